// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL 6 has AABB_traits under another name, and still under this one.
#define CGAL_NO_DEPRECATION_WARNINGS

#include "surface_distance.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

// from all of `a` to the nearest points of `b`
Surface_distance one_way(const Mesh& a, const Mesh& b)
{
  Tree tree(faces(b).first, faces(b).second, b);
  tree.accelerate_distance_queries();
  Surface_distance result = {0, 0};
  double area = 0;
  const auto add = [&](const Point& p, double share_of_area) {
    const double distance = std::sqrt(tree.squared_distance(p));
    result.mean += share_of_area * distance;
    result.greatest = std::max(result.greatest, distance);
    area += share_of_area;
  };
  for(const Point& p : a.points())
    add(p, 0);
  for(auto f : a.faces())
  {
    const auto h = a.halfedge(f);
    const std::array<Point, 3> corners = {a.point(a.source(h)), a.point(a.target(h)), a.point(a.target(a.next(h)))};
    for(int i = 0; i < 3; ++i) // means over these points are exact for quadratic functions
      add(CGAL::barycenter(corners[i], 4., corners[(i + 1) % 3], 1., corners[(i + 2) % 3], 1.),
          PMP::face_area(f, a) / 3);
  }
  result.mean /= area;
  return result;
}

} // namespace

Surface_distance surface_distance(const Mesh& a, const Mesh& b)
{
  const Surface_distance there = one_way(a, b), back = one_way(b, a);
  return {(there.mean + back.mean) / 2, std::max(there.greatest, back.greatest)};
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
