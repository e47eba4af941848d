// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_FIGURE_ESTIMATES_H
#define CGAL_SPIDER_BENCHMARK_FIGURE_ESTIMATES_H

#include "../Estimator.h"

#include <CGAL/Spider/Curvature_estimate_3.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

using Curvature_estimates = std::vector<Curvature_estimate_3<Kernel>>; // one per vertex
using Edge_flags = Mesh::Property_map<Mesh::Edge_index, bool>;

// The estimators that figures use: Spider's default, the same with feature edges, and the paper's.
Curvature_estimates estimate(const Mesh& mesh, double radius);
Curvature_estimates estimate(const Mesh& mesh, double radius, Edge_flags is_feature);
Curvature_estimates estimate_as_published(const Mesh& mesh, double radius);
Curvature_estimates estimate_as_published(const Mesh& mesh, double radius, Edge_flags is_feature);

template <typename Estimates>
std::vector<double> mean_curvatures(const Estimates& estimates)
{
  std::vector<double> values;
  for(const auto& estimate : estimates)
    values.push_back(estimate.mean_curvature());
  return values;
}

template <typename Estimates>
std::vector<double> Gaussian_curvatures(const Estimates& estimates)
{
  std::vector<double> values;
  for(const auto& estimate : estimates)
    values.push_back(estimate.Gaussian_curvature());
  return values;
}

template <typename Estimates>
std::vector<Vector> normals(const Estimates& estimates)
{
  std::vector<Vector> values;
  for(const auto& estimate : estimates)
    values.push_back(estimate.normal);
  return values;
}

// the angle between two unit vectors, in radians
double angle(const Vector& a, const Vector& b);

// how restless a field is: the median over all vertices of the distance to the mean of the neighbours' values, in units
// of the median of the field's absolute values
double roughness(const Mesh& mesh, const std::vector<double>& field);

// the vertex nearest to a point
Mesh::Vertex_index nearest_vertex(const Mesh& mesh, const Point& point);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_FIGURE_ESTIMATES_H
