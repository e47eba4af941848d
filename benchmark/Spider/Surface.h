// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_SURFACE_H
#define CGAL_SPIDER_BENCHMARK_SURFACE_H

#include "Estimator.h"
#include "noise.h"
#include "tessellations.h"

#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

// What a test surface is made from. The same recipe gives the same surface everywhere.
struct Recipe
{
  std::string shape = "saddle";
  Tessellation tessellation = Tessellation::regular;
  std::size_t number_of_vertices = 10000;
  Noise noise;
  std::uint64_t seed = 1;
};

// A noisy mesh with what is true of the surface underneath, per vertex.
struct Surface
{
  Mesh mesh;
  std::vector<Estimate> truth;
  std::vector<double> border_distance; // infinite on closed surfaces
  double mean_edge_length;             // a, of the mesh before noise
  double rms_curvature;                // root of the mean of the squares of all principal curvatures
};

Surface make_surface(const Recipe& recipe);

// The distance of each vertex to the nearest point of a border, straight through space, so never more than along the
// surface; infinite where there is no border. Borders are sampled at steps of a quarter of the mean edge length.
std::vector<double> border_distances(const Mesh& mesh);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_SURFACE_H
