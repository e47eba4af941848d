// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_MEASURES_H
#define CGAL_SPIDER_BENCHMARK_MEASURES_H

#include "Surface.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

// What a table says of many errors. NaN where there are none.
struct Summary
{
  double mean, median, percentile_95, worst;
};

// of non-negative numbers; their order is lost
Summary summarise(std::vector<double>& errors);

// How far estimates are from a reference, vertex by vertex. Curvatures are in units of the RMS curvature (K: of its
// square), angles in degrees. A vertex whose curvatures are NaN is counted, and left out of the rest.
struct Errors
{
  Summary H, K, min_curvature, max_curvature, direction, normal;
  std::size_t vertices = 0; // that were looked at
  std::size_t nan = 0;      // without curvatures among them
  std::size_t wild = 0;     // with an error of H of more than ten times the RMS curvature
};

// Principal directions count where the reference's curvatures differ by more than this share of the RMS curvature: near
// an umbilic there is no right answer.
constexpr double umbilic_difference = 0.1;

constexpr double wild_error = 10;

Errors compare(const std::vector<Estimate>& estimates, const std::vector<Estimate>& reference,
               const std::vector<Mesh::Vertex_index>& vertices, double rms_curvature);

// the vertices farther than `margin` from every border
std::vector<Mesh::Vertex_index> interior_vertices(const Surface& surface, double margin);

// The upper bounds, in units of the radius, of the bins that vertices near a border are sorted into.
constexpr std::array<double, 6> border_bins = {0.1, 0.25, 0.5, 0.75, 1, 2};

// errors by distance from a border, one for each of the bins; none on closed surfaces
std::vector<Errors> compare_by_border_distance(const std::vector<Estimate>& estimates, const Surface& surface,
                                               double radius);

// root mean square of the principal curvatures, the highest and the lowest hundredth left out: scale for data without
// truth
double robust_rms_curvature(const std::vector<Estimate>& estimates);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_MEASURES_H
