// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the tests of tracing measure: polylines, distances to them and to meshes, and what every limb must satisfy.

#ifndef CGAL_SPIDER_TEST_TRACING_H
#define CGAL_SPIDER_TEST_TRACING_H

#include "meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/Limb_3.h>
#include <CGAL/Spider/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace tracing {

namespace Spider = CGAL::Spider;

using meshes::Vector;
using Polyline = std::vector<Vector>;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Epick_polyhedron = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Epeck_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;

/// Both kinds of meshes and all three kernels, for typed tests.
using Mesh_types = ::testing::Types<Mesh, Epick_polyhedron, Epeck_mesh>;

template <typename Mesh>
using Vertex_of = typename boost::graph_traits<Mesh>::vertex_descriptor;
template <typename Mesh>
using Face_of = typename boost::graph_traits<Mesh>::face_descriptor;
/// What `Polygon_mesh_processing::Face_location` is.
template <typename Mesh>
using Location_of =
  std::pair<Face_of<Mesh>, std::array<typename CGAL::Kernel_traits<meshes::Point_of<Mesh>>::Kernel::FT, 3>>;

inline Kernel::Vector_3 kernel_vector(const Vector& a) { return {a.x(), a.y(), a.z()}; }

template <typename Points>
Polyline polyline(const Points& points)
{
  Polyline result;
  for(const auto& p : points)
    result.push_back(meshes::vector(p));
  return result;
}

inline double length(const Polyline& points)
{
  double sum = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    sum += (points[i] - points[i - 1]).norm();
  return sum;
}

inline double distance_to_segment(const Vector& q, const Vector& a, const Vector& b)
{
  const double squared = (b - a).squaredNorm();
  const double share = squared > 0 ? std::clamp((q - a).dot(b - a) / squared, 0., 1.) : 0.;
  return (q - a - share * (b - a)).norm();
}

inline double distance_to_polyline(const Vector& q, const Polyline& points)
{
  double least = points.size() == 1 ? (q - points[0]).norm() : std::numeric_limits<double>::infinity();
  for(std::size_t i = 1; i < points.size(); ++i)
    least = std::min(least, distance_to_segment(q, points[i - 1], points[i]));
  return least;
}

/// returns the greatest distance of a vertex of either polyline to the other one.
inline double distance(const Polyline& a, const Polyline& b)
{
  double greatest = 0;
  for(const Vector& q : a)
    greatest = std::max(greatest, distance_to_polyline(q, b));
  for(const Vector& q : b)
    greatest = std::max(greatest, distance_to_polyline(q, a));
  return greatest;
}

inline double distance_to_triangle(const Vector& q, const Vector& a, const Vector& b, const Vector& c)
{
  const Vector normal = (b - a).cross(c - a);
  const bool is_above = normal.squaredNorm() > 0 && normal.dot((b - a).cross(q - a)) >= 0 &&
                        normal.dot((c - b).cross(q - b)) >= 0 && normal.dot((a - c).cross(q - c)) >= 0;
  if(is_above)
    return std::abs((q - a).dot(normal.normalized()));
  return distance_to_polyline(q, {a, b, c, a});
}

template <typename Mesh>
std::array<Vector, 3> corners(const Mesh& mesh, Face_of<Mesh> f)
{
  const auto h = halfedge(f, mesh);
  return {meshes::point(mesh, source(h, mesh)), meshes::point(mesh, target(h, mesh)),
          meshes::point(mesh, target(next(h, mesh), mesh))};
}

template <typename Mesh>
double distance_to_mesh(const Vector& q, const Mesh& mesh)
{
  double least = std::numeric_limits<double>::infinity();
  for(auto f : faces(mesh))
  {
    const auto [a, b, c] = corners(mesh, f);
    least = std::min(least, distance_to_triangle(q, a, b, c));
  }
  return least;
}

/// returns the sum of the area vectors of the faces around a vertex, normalized.
template <typename Mesh>
Vector vertex_normal(const Mesh& mesh, Vertex_of<Mesh> v)
{
  Vector sum = Vector::Zero();
  for(auto f : CGAL::faces_around_target(halfedge(v, mesh), mesh))
  {
    if(f == boost::graph_traits<Mesh>::null_face())
      continue;
    const auto [a, b, c] = corners(mesh, f);
    sum += (b - a).cross(c - a);
  }
  return sum.normalized();
}

template <typename Mesh>
Vector face_normal(const Mesh& mesh, Face_of<Mesh> f)
{
  const auto [a, b, c] = corners(mesh, f);
  return (b - a).cross(c - a).normalized();
}

/// returns the vertex nearest to a point.
template <typename Mesh>
Vertex_of<Mesh> vertex_at(const Mesh& mesh, const Vector& p)
{
  const auto range = vertices(mesh);
  return *std::min_element(range.begin(), range.end(), [&](auto a, auto b) {
    return (meshes::point(mesh, a) - p).squaredNorm() < (meshes::point(mesh, b) - p).squaredNorm();
  });
}

/// returns the location with the given weights of the corners of a face.
template <typename Mesh>
Location_of<Mesh> location(Face_of<Mesh> f, double a, double b, double c)
{
  return {f, {a, b, c}};
}

template <typename Mesh>
Vector point_of(const Mesh& mesh, const Location_of<Mesh>& location)
{
  const auto [a, b, c] = corners(mesh, location.first);
  const auto& w = location.second;
  return CGAL::to_double(w[0]) * a + CGAL::to_double(w[1]) * b + CGAL::to_double(w[2]) * c;
}

/// expects of a limb what holds of each: it starts at `start`, goes along `direction`, lies in the plane of its cut and
/// on the mesh, and is as long as it says, which is the radius if it says so and less if it ended early.
/// Rounding is relative to the radius and to the coordinates; a few hundred crossings add up.
template <typename Limb, typename Mesh>
void expect_is_limb(const Limb& limb, const Mesh& mesh, const Vector& start, const Vector& normal,
                    const Vector& direction, double radius)
{
  const double rounding = 1e-13 * (radius + start.norm());
  const Vector n = normal.normalized();
  const Vector d = (direction.normalized() - direction.normalized().dot(n) * n).normalized();
  const Vector across = n.cross(d);
  const Polyline points = polyline(limb.polyline);
  ASSERT_GE(points.size(), 1u);
  EXPECT_LE((points[0] - start).norm(), rounding);
  for(const Vector& q : points)
  {
    EXPECT_LE(std::abs((q - start).dot(across)), rounding);
    EXPECT_LE(distance_to_mesh(q, mesh), rounding);
  }
  for(std::size_t i = 1; i < points.size(); ++i)
    EXPECT_LE(distance_to_mesh((points[i - 1] + points[i]) / 2, mesh), rounding);
  if(points.size() > 1)
  {
    EXPECT_GE((points[1] - start).dot(d), -rounding);
  }
  EXPECT_NEAR(length(points), limb.length, rounding);
  if(limb.end == Spider::radius_reached)
    EXPECT_NEAR(limb.length, radius, 1e-15 * radius);
  else
    EXPECT_LT(limb.length, radius);
}

/// expects a call to throw `std::invalid_argument` whose message has all of `parts` in it.
template <typename Call>
void expect_refused(Call&& call, const std::vector<std::string>& parts)
{
  try
  {
    call();
    ADD_FAILURE() << "nothing was thrown; expected was a message about " << parts[0];
  }
  catch(const std::invalid_argument& error)
  {
    for(const std::string& part : parts)
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << "'" << part << "' in: " << error.what();
  }
}

} // namespace tracing

#endif // CGAL_SPIDER_TEST_TRACING_H
