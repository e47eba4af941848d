// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL 6 has AABB_traits under another name, and still under this one.
#define CGAL_NO_DEPRECATION_WARNINGS

#include "stability.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

Mesh flipped(Mesh mesh)
{
  constexpr double share = 0.1;
  Random random(1);
  flip_at_random(mesh, area_weighted_normals(mesh), share, random);
  return mesh;
}

Mesh remeshed(Mesh mesh)
{
  constexpr unsigned int rounds = 3; // as in CGAL's own example of it
  PMP::isotropic_remeshing(mesh.faces(), mean_edge_length(mesh), mesh, CGAL::parameters::number_of_iterations(rounds));
  mesh.collect_garbage();
  return mesh;
}

} // namespace

std::vector<std::pair<std::string, Mesh>> other_triangulations(const Mesh& mesh)
{
  return {{"flipped", flipped(mesh)}, {"remeshed", remeshed(mesh)}};
}

std::vector<Estimate> transfer(const Mesh& from, const std::vector<Estimate>& estimates, const Mesh& to)
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

  Tree tree;
  PMP::build_AABB_tree(from, tree);
  std::vector<Estimate> result;
  result.reserve(to.num_vertices());
  for(auto v : to.vertices())
  {
    const auto [face, weights] = PMP::locate_with_AABB_tree(to.point(v), tree, from);
    const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
    double min_curvature = 0, max_curvature = 0;
    Estimate here;
    auto h = from.halfedge(face);
    for(std::ptrdiff_t i = 0; i < 3; ++i, h = from.next(h)) // the first weight is that of the halfedge's source
    {
      const Estimate& corner = estimates[from.source(h)];
      min_curvature += weights[static_cast<std::size_t>(i)] * corner.min_curvature;
      max_curvature += weights[static_cast<std::size_t>(i)] * corner.max_curvature;
      if(i == nearest)
        here = corner;
    }
    here.min_curvature = min_curvature;
    here.max_curvature = max_curvature;
    result.push_back(here);
  }
  return result;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
