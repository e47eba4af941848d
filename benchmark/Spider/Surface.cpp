// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

std::vector<Point> border_samples(const Mesh& mesh, double step)
{
  std::vector<Point> samples;
  for(auto edge : mesh.edges())
  {
    if(!mesh.is_border(edge))
      continue;
    const Point from = mesh.point(mesh.vertex(edge, 0)), to = mesh.point(mesh.vertex(edge, 1));
    const double pieces = std::ceil(std::sqrt(CGAL::squared_distance(from, to)) / step);
    for(double i = 0; i <= pieces; ++i)
      samples.push_back(from + i / pieces * (to - from));
  }
  return samples;
}

double rms_curvature(const std::vector<Estimate>& truth)
{
  double sum = 0;
  for(const Estimate& t : truth)
    sum += t.min_curvature * t.min_curvature + t.max_curvature * t.max_curvature;
  return std::sqrt(sum / (2 * static_cast<double>(truth.size())));
}

} // namespace

std::vector<double> border_distances(const Mesh& mesh)
{
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;

  std::vector<double> distances(mesh.num_vertices(), std::numeric_limits<double>::infinity());
  const std::vector<Point> samples = border_samples(mesh, mean_edge_length(mesh) / 4);
  if(samples.empty())
    return distances;
  Search::Tree tree(samples.begin(), samples.end());
  for(auto v : mesh.vertices())
    distances[v] = std::sqrt(Search(tree, mesh.point(v), 1).begin()->second);
  return distances;
}

Surface make_surface(const Recipe& recipe)
{
  const Shape_ptr shape = make_shape(recipe.shape);
  Random random(recipe.seed);
  Surface surface;
  surface.mesh = tessellate(*shape, recipe.tessellation, recipe.number_of_vertices, random);
  surface.mean_edge_length = mean_edge_length(surface.mesh);
  surface.border_distance = border_distances(surface.mesh);

  std::vector<Vector> normals;
  for(auto v : surface.mesh.vertices())
  {
    surface.truth.push_back(shape->truth(surface.mesh.point(v)));
    normals.push_back(surface.truth.back().normal);
  }
  surface.rms_curvature = rms_curvature(surface.truth);
  add_noise(surface.mesh, normals, surface.mean_edge_length, recipe.noise, random);
  return surface;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
