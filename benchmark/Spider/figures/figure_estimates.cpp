// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "figure_estimates.h"

#include <CGAL/Spider/estimate_vertex_curvatures.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

template <typename NamedParameters>
Curvature_estimates estimate_with(const Mesh& mesh, const NamedParameters& np)
{
  Curvature_estimates estimates(mesh.num_vertices());
  const auto map = boost::make_iterator_property_map(estimates.begin(), get(boost::vertex_index, mesh));
  estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, map, np);
  return estimates;
}

double median(std::vector<double> values)
{
  values.erase(std::remove_if(values.begin(), values.end(), [](double x) { return !std::isfinite(x); }), values.end());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

Curvature_estimates estimate(const Mesh& mesh, double radius)
{
  return estimate_with(mesh, parameters::geodesic_radius(radius));
}

Curvature_estimates estimate(const Mesh& mesh, double radius, Edge_flags is_feature)
{
  return estimate_with(mesh, parameters::geodesic_radius(radius).edge_is_constrained_map(is_feature));
}

Curvature_estimates estimate_as_published(const Mesh& mesh, double radius)
{
  return estimate_with(mesh, parameters::as_published().geodesic_radius(radius));
}

Curvature_estimates estimate_as_published(const Mesh& mesh, double radius, Edge_flags is_feature)
{
  return estimate_with(mesh, parameters::as_published().geodesic_radius(radius).edge_is_constrained_map(is_feature));
}

double angle(const Vector& a, const Vector& b)
{
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
}

double roughness(const Mesh& mesh, const std::vector<double>& field)
{
  std::vector<double> differences, magnitudes;
  for(auto v : mesh.vertices())
  {
    double sum = 0;
    std::size_t count = 0;
    for(auto w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
    {
      sum += field[w];
      ++count;
    }
    differences.push_back(std::abs(field[v] - sum / static_cast<double>(count)));
    magnitudes.push_back(std::abs(field[v]));
  }
  return median(std::move(differences)) / median(std::move(magnitudes));
}

Mesh::Vertex_index nearest_vertex(const Mesh& mesh, const Point& point)
{
  return *std::min_element(mesh.vertices().begin(), mesh.vertices().end(), [&](auto v, auto w) {
    return CGAL::squared_distance(mesh.point(v), point) < CGAL::squared_distance(mesh.point(w), point);
  });
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
