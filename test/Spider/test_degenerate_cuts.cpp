// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One rule decides every degenerate case, and every walk ends: where the cut runs through vertices and along edges,
// across faces without area, from borders, on folded stars, and through points that are none.

#include <CGAL/Spider/trace_limb.h>
#include <CGAL/Spider/trace_limbs.h>

#include "tracing.h"

#include <CGAL/boost/graph/Euler_operations.h>

namespace {

using namespace tracing;
using Spider::trace_limb;
using Spider::parameters::geodesic_radius;

const Kernel::Vector_3 up(0, 0, 1);
const auto all_diagonals = {meshes::forward, meshes::backward, meshes::alternating};

/// returns directions in the plane that lead through many vertices and along many edges of a grid, and some that don't.
std::vector<Vector> grid_directions()
{
  std::vector<Vector> result;
  for(int x = -2; x <= 2; ++x)
    for(int y = -2; y <= 2; ++y)
      if(x != 0 || y != 0)
        result.push_back(Vector(x, y, 0).normalized());
  result.push_back(Vector(1, 1e-17, 0));
  result.push_back(Vector(-1e-17, 1, 0));
  result.push_back(Vector(1, 1 + 1e-15, 0).normalized());
  return result;
}

/// expects a limb to lead straight on, from its start as far as `radius`.
template <typename Limb>
void expect_straight(const Limb& limb, const Vector& start, const Vector& direction, double radius)
{
  const double rounding = 1e-13 * (1 + radius);
  EXPECT_EQ(limb.end, Spider::radius_reached) << "along " << direction.transpose() << " from " << start.transpose();
  EXPECT_NEAR(limb.length, radius, rounding);
  const Polyline points = polyline(limb.polyline);
  EXPECT_NEAR(length(points), radius, rounding);
  EXPECT_LE((points.back() - start - radius * direction).norm(), rounding)
    << "along " << direction.transpose() << " from " << start.transpose();
}

TEST(Degenerate_cuts, run_straight_through_vertices_and_along_edges_of_a_grid)
{
  for(auto diagonals : all_diagonals)
  {
    const Mesh mesh = meshes::plane<Mesh>(6, 1, diagonals);
    for(auto v : vertices(mesh))
    {
      const Vector p = meshes::point(mesh, v);
      if(p.lpNorm<Eigen::Infinity>() > 1)
        continue;
      for(const Vector& d : grid_directions())
        for(double radius : {1e-6, 0.5, 1., std::sqrt(2.), 4.5})
          expect_straight(trace_limb(v, up, kernel_vector(d), mesh, geodesic_radius(radius)), p, d, radius);
    }
  }
}

TEST(Degenerate_cuts, run_straight_from_edges_and_from_inside_faces)
{
  for(auto diagonals : all_diagonals)
  {
    const Mesh mesh = meshes::plane<Mesh>(4, 1, diagonals);
    for(auto f : faces(mesh))
      for(const std::array<double, 3>& w : {std::array<double, 3>{0.5, 0.5, 0},
                                            {0, 0.25, 0.75},
                                            {0.5, 0.25, 0.25},
                                            {1 - 1e-12, 1e-12, 0},
                                            {1 - 1e-16, 1e-16, 0},
                                            {1e-300, 0.5, 0.5}})
      {
        const auto query = location<Mesh>(f, w[0], w[1], w[2]);
        const Vector p = point_of(mesh, query);
        if(p.lpNorm<Eigen::Infinity>() > 1)
          continue;
        for(const Vector& d : grid_directions())
          expect_straight(trace_limb(query, up, kernel_vector(d), mesh, geodesic_radius(2.5)), p, d, 2.5);
      }
  }
}

TEST(Degenerate_cuts, run_around_a_cube_along_its_edges_and_through_its_vertices)
{
  // The limb's start, normal and direction, and the corners of the section: the walk goes along them in their order.
  struct Case
  {
    Vector normal, direction;
    Polyline section;
  };
  const double a = 0.5;
  const std::vector<Case> cases = {
    {{0, 0, 1}, {1, 0, 0}, {{a, a, 1}, {1, a, 1}, {1, a, 0}, {0, a, 0}, {0, a, 1}, {a, a, 1}}},
    {{0, 0, 1}, {0, -1, 0}, {{a, a, 1}, {a, 0, 1}, {a, 0, 0}, {a, 1, 0}, {a, 1, 1}, {a, a, 1}}},
    {{0, 0, 1}, {1, 1, 0}, {{a, a, 1}, {1, 1, 1}, {1, 1, 0}, {0, 0, 0}, {0, 0, 1}, {a, a, 1}}},
    {{0, 0, 1}, {1, -1, 0}, {{a, a, 1}, {1, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1}, {a, a, 1}}},
    {{1, 0, 1}, {0, 1, 0}, {{1, a, 1}, {1, 1, 1}, {0, 1, 0}, {0, 0, 0}, {1, 0, 1}, {1, a, 1}}},
    {{1, 0, 1}, {0, -1, 0}, {{1, a, 1}, {1, 0, 1}, {0, 0, 0}, {0, 1, 0}, {1, 1, 1}, {1, a, 1}}},
    {{1, 1, 1}, {-1, -1, 2}, {{1, 1, 1}, {0, 0, 1}, {0, 0, 0}, {1, 1, 0}, {1, 1, 1}}}};
  for(auto diagonals : all_diagonals)
    for(int n : {2, 4, 6})
    {
      const Mesh mesh = meshes::cube<Mesh>(n, diagonals);
      for(const Case& c : cases)
      {
        const auto v = vertex_at(mesh, c.section.front());
        const double around = length(c.section);
        const auto limb_of = [&](double radius) {
          return trace_limb(v, kernel_vector(c.normal), kernel_vector(c.direction), mesh, geodesic_radius(radius));
        };
        double walked = 0;
        for(std::size_t i = 0; i + 1 < c.section.size(); ++i)
        { // halfway along each side of the section
          const double side = (c.section[i + 1] - c.section[i]).norm();
          const auto limb = limb_of(walked + side / 2);
          EXPECT_EQ(limb.end, Spider::radius_reached);
          EXPECT_LE((meshes::vector(limb.polyline.back()) - (c.section[i] + c.section[i + 1]) / 2).norm(), 1e-13);
          EXPECT_NEAR(length(polyline(limb.polyline)), walked + side / 2, 1e-13);
          walked += side;
        }
        const auto limb = limb_of(10);
        EXPECT_EQ(limb.end, Spider::degenerate);
        EXPECT_NEAR(limb.length, around, 1e-12);
        EXPECT_LE(distance(polyline(limb.polyline), c.section), 1e-12);
      }
    }
}

TEST(Degenerate_cuts, run_along_a_straight_border_on_whichever_side_the_surface_is)
{
  for(auto diagonals : all_diagonals)
  {
    const Mesh mesh = meshes::plane<Mesh>(4, 1, diagonals);
    for(const Vector& along : {Vector(1, 0, 0), Vector(0, 1, 0), Vector(-1, 0, 0), Vector(0, -1, 0)})
    {
      const Vector inwards(-along.y(), along.x(), 0);
      for(double side : {-1., 1.})
      {
        const Vector p = -4 * side * inwards;
        const auto v = vertex_at(mesh, p);
        expect_straight(trace_limb(v, up, kernel_vector(along), mesh, geodesic_radius(3.5)), p, along, 3.5);
        const auto end = trace_limb(v, up, kernel_vector(along), mesh, geodesic_radius(9));
        EXPECT_EQ(end.end, Spider::border);
        EXPECT_NEAR(end.length, 4, 1e-12);
        EXPECT_LE((meshes::vector(end.polyline.back()) - p - 4 * along).norm(), 1e-12);
        const auto inner = trace_limb(v, up, kernel_vector(side * inwards), mesh, geodesic_radius(3.5));
        expect_straight(inner, p, side * inwards, 3.5);
        const auto outer = trace_limb(v, up, kernel_vector(-side * inwards), mesh, geodesic_radius(3.5));
        EXPECT_EQ(outer.polyline.size(), 1u);
        EXPECT_EQ(outer.end, Spider::border);
      }
    }
  }
}

TEST(Degenerate_cuts, run_along_the_border_of_a_single_triangle)
{
  const Mesh mesh = meshes::from_soup<Mesh>({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}});
  const auto corner = vertex_at(mesh, {0, 0, 0});
  for(const auto& [d, length] : {std::pair<Vector, double>{{1, 0, 0}, 4}, {{0, 1, 0}, 3}, {{0.6, 0.8, 0}, 2.4}})
  {
    const auto limb = trace_limb(corner, up, kernel_vector(d), mesh, geodesic_radius(100));
    EXPECT_EQ(limb.end, Spider::border);
    EXPECT_NEAR(limb.length, length, 1e-12);
    expect_straight(trace_limb(corner, up, kernel_vector(d), mesh, geodesic_radius(2)), {0, 0, 0}, d, 2);
  }
  for(const Vector& d : {Vector(-1, 0, 0), Vector(0, -1, 0), Vector(1, -0.1, 0), Vector(-0.1, 1, 0)})
    EXPECT_EQ(trace_limb(corner, up, kernel_vector(d), mesh, geodesic_radius(2)).polyline.size(), 1u);
}

/// returns a plane that has caps, faces without area whose corners are on one line, at the middles of many edges.
Mesh plane_with_caps(int n)
{
  Mesh mesh = meshes::plane<Mesh>(n);
  std::vector<Mesh::Halfedge_index> to_split;
  std::vector<bool> is_used(mesh.number_of_faces(), false);
  for(auto e : mesh.edges())
  {
    const auto h = mesh.halfedge(e), o = mesh.opposite(h);
    if(mesh.is_border(e) || is_used[mesh.face(h)] || is_used[mesh.face(o)])
      continue;
    is_used[mesh.face(h)] = is_used[mesh.face(o)] = true;
    to_split.push_back(h);
  }
  for(auto h : to_split)
  {
    const Kernel::Point_3 middle = CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    const auto first = CGAL::Euler::split_edge(h, mesh), second = mesh.next(first);
    mesh.point(mesh.target(first)) = middle;
    const auto back = mesh.opposite(first), forth = mesh.prev(mesh.opposite(second));
    CGAL::Euler::split_face(first, mesh.next(second), mesh); // from the middle to the apex
    CGAL::Euler::split_face(back, forth, mesh);              // from end to end, which cuts the cap off
  }
  return mesh;
}

TEST(Degenerate_cuts, run_straight_across_faces_whose_corners_are_on_one_line)
{
  const Mesh mesh = plane_with_caps(5);
  ASSERT_TRUE(CGAL::is_triangle_mesh(mesh));
  int flat = 0;
  for(auto f : faces(mesh))
  {
    const auto [a, b, c] = corners(mesh, f);
    flat += (b - a).cross(c - a).isZero();
  }
  ASSERT_GE(flat, 20);
  for(auto v : vertices(mesh))
  {
    const Vector p = meshes::point(mesh, v);
    if(p.lpNorm<Eigen::Infinity>() > 1)
      continue;
    for(const Vector& d : grid_directions())
      expect_straight(trace_limb(v, up, kernel_vector(d), mesh, geodesic_radius(3.5)), p, d, 3.5);
  }
  for(auto f : faces(mesh))
  {
    const auto query = location<Mesh>(f, 0.2, 0.3, 0.5);
    const auto [a, b, c] = corners(mesh, f);
    const Vector p = point_of(mesh, query);
    if(p.lpNorm<Eigen::Infinity>() > 1)
      continue;
    for(const Vector& d : grid_directions())
    {
      const auto limb = trace_limb(query, up, kernel_vector(d), mesh, geodesic_radius(3.5));
      const bool is_along_cap = (b - a).cross(c - a).isZero() && (b - a).cross(d).norm() < 1e-12;
      if(is_along_cap) // all corners are on the plane, so the face around the query isn't cut
      {
        EXPECT_EQ(limb.end, Spider::degenerate);
        EXPECT_EQ(limb.polyline.size(), 1u);
      }
      else
      {
        expect_straight(limb, p, d, 3.5);
      }
    }
  }
}

TEST(Degenerate_cuts, run_straight_where_vertices_are_in_one_place)
{
  const Mesh mesh = meshes::moved(meshes::plane<Mesh>(6), [](const Vector& p) {
    return std::abs(p.x()) <= 1 && p.y() == 0 ? Vector(0, 0, 0) : p; // three vertices in one place
  });
  for(auto v : vertices(mesh))
  {
    const Vector p = meshes::point(mesh, v);
    if(p.lpNorm<Eigen::Infinity>() > 2)
      continue;
    for(const Vector& d : grid_directions())
      expect_straight(trace_limb(v, up, kernel_vector(d), mesh, geodesic_radius(3.5)), p, d, 3.5);
  }
}

TEST(Degenerate_cuts, run_straight_from_slivers)
{
  for(double height : {1e-6, 1e-12, 1e-15})
  {
    const Mesh mesh = meshes::moved(meshes::plane<Mesh>(4), [&](const Vector& p) {
      return p.y() == 1 ? Vector(p.x(), height, 0) : p; // a row of faces as low as that
    });
    for(auto f : faces(mesh))
    {
      const auto query = location<Mesh>(f, 0.2, 0.3, 0.5);
      const Vector p = point_of(mesh, query);
      if(p.lpNorm<Eigen::Infinity>() > 1)
        continue;
      for(const Vector& d : grid_directions())
      {
        const bool is_cut = height > 1e-14 || std::abs(d.y()) > 1e-14; // else all corners are on the plane
        if(is_cut)
          expect_straight(trace_limb(query, up, kernel_vector(d), mesh, geodesic_radius(2.5)), p, d, 2.5);
      }
    }
  }
}

TEST(Degenerate_cuts, take_the_way_of_least_slope_on_a_folded_star)
{
  // The fan around the origin turns back over itself, so that the direction at 150 degrees meets three of its faces.
  struct Spoke
  {
    double degrees, height;
  };
  for(int flattest : {0, 1, 2})
  {
    const double heights[] = {flattest == 0 ? 0.1 : 1, flattest == 1 ? 0.1 : 2, flattest == 2 ? -0.1 : -1};
    const std::vector<Spoke> spokes = {
      {0, 0},  {90, heights[0]}, {180, heights[0] + heights[1]}, {120, heights[1] + heights[2]}, {200, heights[2]},
      {280, 0}};
    std::vector<Vector> points = {{0, 0, 0}};
    std::vector<meshes::Triangle> triangles;
    for(std::size_t i = 0; i < spokes.size(); ++i)
    {
      const double angle = spokes[i].degrees * meshes::pi / 180;
      points.emplace_back(std::cos(angle), std::sin(angle), spokes[i].height);
      triangles.push_back({0, i + 1, (i + 1) % spokes.size() + 1});
    }
    const Mesh mesh = meshes::from_soup<Mesh>(points, triangles);
    const Vector d(std::cos(5 * meshes::pi / 6), std::sin(5 * meshes::pi / 6), 0);

    // where each face is cut, and the flattest of those cuts
    Vector expected = Vector::Zero();
    double least = std::numeric_limits<double>::infinity();
    for(const auto& [apex, i, j] : triangles)
    {
      const double a = points[i].cross(d).z(), b = points[j].cross(d).z();
      const Vector q = points[i] + a / (a - b) * (points[j] - points[i]);
      if(a * b < 0 && q.dot(d) > 0 && std::abs(q.z() / q.dot(d)) < least)
      {
        least = std::abs(q.z() / q.dot(d));
        expected = q;
      }
    }
    const auto limb = trace_limb(vertex_at(mesh, {0, 0, 0}), up, kernel_vector(d), mesh, geodesic_radius(10));
    EXPECT_EQ(limb.end, Spider::border);
    EXPECT_LE((meshes::vector(limb.polyline.back()) - expected).norm(), 1e-12);
  }
}

TEST(Degenerate_cuts, end_at_points_that_are_none)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for(const Vector& bad :
      {Vector(nan, 0, 0), Vector(0, 0, nan), Vector(infinity, 0, 0), Vector(0, -infinity, infinity)})
  {
    Mesh mesh = meshes::plane<Mesh>(4);
    const auto spoilt = vertex_at(mesh, {1, 0, 0});
    mesh.point(spoilt) = Kernel::Point_3(bad.x(), bad.y(), bad.z());
    for(auto v : vertices(mesh))
    {
      std::vector<Spider::Limb_3<Mesh>> limbs;
      Spider::trace_limbs(v, up, mesh, std::back_inserter(limbs), geodesic_radius(2.5).number_of_directions(16));
      EXPECT_EQ(limbs.size(), 32u);
      for(const auto& limb : limbs)
      {
        if(v == spoilt)
        {
          EXPECT_NE(limb.end, Spider::radius_reached);
          continue;
        }
        EXPECT_TRUE(std::isfinite(limb.length));
        for(const auto& q : limb.polyline)
          EXPECT_TRUE(meshes::vector(q).allFinite());
        if(limb.end == Spider::radius_reached)
        {
          EXPECT_NEAR(length(polyline(limb.polyline)), 2.5, 1e-12);
        }
      }
    }
    // Those that keep away from it are none the worse.
    const auto limb =
      trace_limb(vertex_at(mesh, {0, 0, 0}), up, Kernel::Vector_3(-1, 0.1, 0), mesh, geodesic_radius(3));
    EXPECT_EQ(limb.end, Spider::radius_reached);
  }
}

TEST(Degenerate_cuts, end_on_small_closed_components_however_large_the_radius)
{
  const Mesh tetrahedron = meshes::from_soup<Mesh>({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
  for(double radius : {10., 1e6, 1e9})
    for(auto v : vertices(tetrahedron))
    {
      std::vector<Spider::Limb_3<Mesh>> limbs;
      Spider::trace_limbs(v, kernel_vector(vertex_normal(tetrahedron, v)), tetrahedron, std::back_inserter(limbs),
                          geodesic_radius(radius));
      for(const auto& limb : limbs)
      {
        const Polyline points = polyline(limb.polyline);
        const double rounding = 1e-14 * radius;
        EXPECT_EQ(limb.end, Spider::degenerate);
        EXPECT_NEAR(limb.length, length(points), 10 * rounding);
        EXPECT_LE((points.back() - points.front()).norm(), 10 * rounding + 1e-12);
        // Two sides from the corner to the opposite face, each at least its height, and none longer than an edge.
        EXPECT_GE(limb.length, 2 * std::sqrt(6.) - rounding);
        EXPECT_LE(limb.length, 3 * std::sqrt(8.) + rounding);
      }
    }
}

TEST(Degenerate_cuts, hold_from_the_smallest_to_the_largest_radius)
{
  const Mesh mesh = meshes::plane<Mesh>(3);
  const auto v = vertex_at(mesh, {1, -1, 0});
  for(const Vector& d : grid_directions())
  {
    for(double radius : {1e-12, 1e-6, 1e-3})
      EXPECT_LE((meshes::vector(trace_limb(v, up, kernel_vector(d), mesh, geodesic_radius(radius)).polyline.back()) -
                 Vector(1, -1, 0) - radius * d)
                  .norm(),
                1e-15);
    for(double radius : {1e3, 1e6})
    {
      const auto limb = trace_limb(v, up, kernel_vector(d), mesh, geodesic_radius(radius));
      EXPECT_EQ(limb.end, Spider::border);
      EXPECT_NEAR(meshes::vector(limb.polyline.back()).lpNorm<Eigen::Infinity>(), 3, 1e-12 * radius);
    }
  }
}

TEST(Degenerate_cuts, are_decided_alike_at_any_scale_and_place)
{
  const auto limb_of = [](const Mesh& mesh, int vertex, const Vector& d, double radius) {
    return trace_limb(*std::next(vertices(mesh).begin(), vertex), up, kernel_vector(d), mesh, geodesic_radius(radius));
  };
  const Mesh mesh = meshes::plane<Mesh>(4, 1, meshes::alternating);
  for(int vertex : {40, 39, 31})
  {
    const Vector p = meshes::point(mesh, *std::next(vertices(mesh).begin(), vertex));
    for(const Vector& d : grid_directions())
    {
      for(int exponent : {-300, 300})
      {
        const double scale = std::ldexp(1., exponent);
        const Mesh scaled = meshes::moved(mesh, [&](const Vector& q) { return Vector(scale * q); });
        const auto limb = limb_of(scaled, vertex, d, 2.5 * scale);
        EXPECT_EQ(limb.end, Spider::radius_reached);
        EXPECT_LE((meshes::vector(limb.polyline.back()) / scale - p - 2.5 * d).norm(), 1e-13);
      }
      const Vector far(1e8, -1e8, 1e8);
      const Mesh moved = meshes::moved(mesh, [&](const Vector& q) { return Vector(q + far); });
      const auto limb = limb_of(moved, vertex, d, 2.5);
      EXPECT_EQ(limb.end, Spider::radius_reached);
      EXPECT_LE((meshes::vector(limb.polyline.back()) - far - p - 2.5 * d).norm(), 1e-6); // 60 roundings of 1e8
    }
  }
}

} // namespace
