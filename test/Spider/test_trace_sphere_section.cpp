// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spider/trace_sphere_section.h>

#include "tracing.h"

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

namespace {

using namespace tracing;
using Spider::parameters::geodesic_radius;

template <typename Mesh>
class Trace_sphere_section : public ::testing::Test
{};
TYPED_TEST_SUITE(Trace_sphere_section, Mesh_types, );

template <typename Query, typename Mesh>
std::vector<Polyline> section(const Query& query, const Mesh& mesh, double radius)
{
  std::vector<Polyline> result;
  for(const auto& points : Spider::trace_sphere_section(query, mesh, geodesic_radius(radius)))
    result.push_back(polyline(points));
  return result;
}

bool is_closed(const Polyline& points) { return points.size() > 2 && points.front() == points.back(); }

double total_length(const std::vector<Polyline>& polylines)
{
  double sum = 0;
  for(const Polyline& points : polylines)
    sum += length(points);
  return sum;
}

/// returns by how much polylines run counter-clockwise around `p` as seen from the tip of `normal`, as an angle.
double turning_angle(const std::vector<Polyline>& polylines, const Vector& p, const Vector& normal)
{
  double sum = 0;
  for(const Polyline& points : polylines)
    for(std::size_t i = 1; i < points.size(); ++i)
    {
      const Vector a = points[i - 1] - p, b = points[i] - p;
      const Vector u = a - a.dot(normal) * normal, w = b - b.dot(normal) * normal;
      sum += std::atan2(normal.dot(u.cross(w)), u.dot(w));
    }
  return sum;
}

/// Chords of at most 0.2 radians: so much shorter than the arc, and so much nearer to the centre, are they at most.
const double chord_share = std::sin(0.1) / 0.1, chord_depth = std::cos(0.1);

/// expects points on the sphere and on the mesh, and no chord far inside the sphere. The meshes' size is around 1
/// to 10.
template <typename Mesh>
void expect_is_section(const std::vector<Polyline>& polylines, const Mesh& mesh, const Vector& p, double radius)
{
  const double rounding = 1e-13 * (radius + 1);
  for(const Polyline& points : polylines)
  {
    ASSERT_GE(points.size(), 2u);
    for(const Vector& q : points)
    {
      EXPECT_NEAR((q - p).norm(), radius, rounding);
      EXPECT_LE(distance_to_mesh(q, mesh), rounding);
    }
    for(std::size_t i = 1; i < points.size(); ++i)
      EXPECT_GE(((points[i - 1] + points[i]) / 2 - p).norm(), chord_depth * radius - rounding);
  }
}

TYPED_TEST(Trace_sphere_section, lies_on_the_sphere_and_on_the_mesh_and_is_closed)
{
  const auto mesh = meshes::jittered(meshes::icosphere<TypeParam>(2), 0.03, 1);
  const auto check = [&](const auto& query, const Vector& p, const Vector& n, double radius) {
    const auto polylines = section(query, mesh, radius);
    ASSERT_EQ(polylines.size(), 1u);
    EXPECT_TRUE(is_closed(polylines[0]));
    expect_is_section(polylines, mesh, p, radius);
    EXPECT_NEAR(turning_angle(polylines, p, n), 2 * meshes::pi, 1e-9);
  };
  const auto vertex = *std::next(vertices(mesh).begin(), 50);
  const auto face = *std::next(faces(mesh).begin(), 100);
  const auto inside = location<TypeParam>(face, 0.2, 0.3, 0.5), on_edge = location<TypeParam>(face, 0, 0.3, 0.7);
  for(double radius : {1e-6, 0.01, 0.2, 0.7, 1.1})
  {
    check(vertex, meshes::point(mesh, vertex), vertex_normal(mesh, vertex), radius);
    check(inside, point_of(mesh, inside), face_normal(mesh, face), radius);
    check(on_edge, point_of(mesh, on_edge), face_normal(mesh, face), radius);
  }
}

TYPED_TEST(Trace_sphere_section, is_the_same_from_a_vertex_and_from_that_corner_of_each_face)
{
  const auto mesh = meshes::jittered(meshes::torus<TypeParam>(1, 0.4, 12, 8), 0.02, 3);
  const auto v = *std::next(vertices(mesh).begin(), 40);
  const auto expected = section(v, mesh, 0.5);
  for(auto f : CGAL::faces_around_target(halfedge(v, mesh), mesh))
  {
    const auto h = halfedge(f, mesh);
    EXPECT_EQ(
      section(location<TypeParam>(f, source(h, mesh) == v, target(h, mesh) == v, target(next(h, mesh), mesh) == v),
              mesh, 0.5),
      expected);
  }
}

/// returns the length of the part of a circle inside the square [-half, half]², by sampling.
double length_inside_square(const Vector& p, double radius, double half)
{
  constexpr int samples = 100000;
  int inside = 0;
  for(int i = 0; i < samples; ++i)
  {
    const double angle = 2 * meshes::pi * (i + 0.5) / samples;
    inside += std::abs(p.x() + radius * std::cos(angle)) < half && std::abs(p.y() + radius * std::sin(angle)) < half;
  }
  return 2 * meshes::pi * radius * inside / samples;
}

TEST(Trace_sphere_section, is_a_circle_on_a_plane_as_far_as_the_plane_goes)
{
  std::mt19937 random(2);
  const Mesh regular = meshes::plane<Mesh>(6), split_alternately = meshes::plane<Mesh>(6, 1, meshes::alternating);
  const Mesh coarse = meshes::plane<Mesh>(1, 6);
  const Mesh noisy = meshes::moved(meshes::jittered(meshes::plane<Mesh>(6), 0.3, 3), [](const Vector& p) {
    const bool on_border = p.lpNorm<Eigen::Infinity>() > 5.5; // move the inner vertices alone
    return on_border ? Vector(std::round(p.x()), std::round(p.y()), 0) : Vector(p.x(), p.y(), 0);
  });
  for(const Mesh* mesh : {&regular, &split_alternately, &coarse, &noisy})
    for(int i = 0; i < 100; ++i)
    {
      const double a = random() / 4294967296., b = (1 - a) * (random() / 4294967296.);
      const auto query =
        location<Mesh>(*std::next(faces(*mesh).begin(), random() % faces(*mesh).size()), a, b, 1 - a - b);
      const Vector p = point_of(*mesh, query);
      const double radius = std::ldexp(8 * (random() / 4294967296.), -int(random() % 4));
      const auto polylines = section(query, *mesh, radius);
      expect_is_section(polylines, *mesh, p, radius);
      const double expected = length_inside_square(p, radius, 6), sampling = 1e-3 * radius;
      EXPECT_LE(total_length(polylines), expected + sampling) << "radius " << radius << " around " << p.transpose();
      EXPECT_GE(total_length(polylines), chord_share * expected - sampling) << "radius " << radius;
      EXPECT_NEAR(turning_angle(polylines, p, {0, 0, 1}), expected / radius, 1e-3);
    }
}

TEST(Trace_sphere_section, is_a_circle_where_the_sphere_meets_vertices_of_a_plane)
{
  // Turned, so that rounding puts the vertices that are met now inside, now outside.
  for(double angle : {0., 0.1, 0.7, 1.3})
    for(auto diagonals : {meshes::forward, meshes::backward, meshes::alternating})
    {
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector(1, 2, 3).normalized()).toRotationMatrix();
      const Mesh mesh =
        meshes::moved(meshes::plane<Mesh>(8, 1, diagonals), [&](const Vector& q) { return Vector(turn * q); });
      for(double radius : {1., 2., 5., 6., std::sqrt(2.), std::sqrt(5.), std::sqrt(13.), std::sqrt(8.)})
        for(const Vector& place : {Vector(0, 0, 0), Vector(1, 1, 0), Vector(-1, 2, 0)})
        {
          const Vector p = turn * place;
          const auto polylines = section(vertex_at(mesh, p), mesh, radius);
          ASSERT_EQ(polylines.size(), 1u);
          EXPECT_TRUE(is_closed(polylines[0]));
          EXPECT_LE(length(polylines[0]), 2 * meshes::pi * radius * (1 + 1e-13)) << "radius " << radius;
          EXPECT_GE(length(polylines[0]), 2 * meshes::pi * radius * chord_share) << "radius " << radius;
          EXPECT_NEAR(turning_angle(polylines, p, turn * Vector(0, 0, 1)), 2 * meshes::pi, 1e-12);
          for(const Vector& q : polylines[0])
            EXPECT_NEAR((q - p).norm(), radius, 1e-13 * (radius + 1));
        }
    }
}

TEST(Trace_sphere_section, tends_to_a_circle_on_a_sphere_as_the_square_of_the_edge_length)
{
  const double radius = 0.7;
  for(int level : {2, 3, 4, 5})
  {
    const Mesh mesh = meshes::icosphere<Mesh>(level);
    double longest_edge = 0;
    for(auto e : edges(mesh))
      longest_edge = std::max(longest_edge,
                              (meshes::point(mesh, mesh.vertex(e, 0)) - meshes::point(mesh, mesh.vertex(e, 1))).norm());
    const auto v = *vertices(mesh).begin();
    const Vector p = meshes::point(mesh, v);
    const auto polylines = section(v, mesh, radius);
    ASSERT_EQ(polylines.size(), 1u);
    EXPECT_TRUE(is_closed(polylines[0]));
    EXPECT_NEAR(turning_angle(polylines, p, p), 2 * meshes::pi, 1e-12);
    for(const Vector& q : polylines[0])
    {
      // On the unit sphere q p = 1 - r²/2. On a facet it is less by half of 1 - q², which is at most the square of the
      // radius of the facet's circumcircle, and that of an acute triangle is at most a third of its longest edge's
      // square.
      const double depth = 1 - radius * radius / 2 - q.dot(p), rounding = 1e-14;
      EXPECT_GE(depth, -rounding);
      EXPECT_LE(depth, longest_edge * longest_edge / 6 + rounding);
    }
  }
}

TEST(Trace_sphere_section, is_three_quarter_circles_at_a_corner_of_a_cube)
{
  for(auto diagonals : {meshes::forward, meshes::backward, meshes::alternating})
  {
    const Mesh mesh = meshes::cube<Mesh>(4, diagonals);
    for(const Vector& p : {Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(1, 1, 1)})
      for(double radius : {0.1, 0.25, 0.5, 0.6, 0.9})
      {
        const auto polylines = section(vertex_at(mesh, p), mesh, radius);
        ASSERT_EQ(polylines.size(), 1u);
        EXPECT_TRUE(is_closed(polylines[0]));
        expect_is_section(polylines, mesh, p, radius);
        const double expected = 3 * meshes::pi / 2 * radius;
        EXPECT_LE(length(polylines[0]), expected);
        EXPECT_GE(length(polylines[0]), expected * chord_share);
        EXPECT_NEAR(turning_angle(polylines, p, Vector(p - Vector(0.5, 0.5, 0.5)).normalized()), 2 * meshes::pi, 1e-12);
      }
  }
}

TEST(Trace_sphere_section, is_open_at_a_border)
{
  const Mesh mesh = meshes::plane<Mesh>(4);
  for(const auto& [p, share] : {std::pair<Vector, double>{{4, 0, 0}, 0.5}, {{0, -4, 0}, 0.5}, {{-4, 4, 0}, 0.25}})
  {
    const auto polylines = section(vertex_at(mesh, p), mesh, 2.5);
    ASSERT_EQ(polylines.size(), 1u);
    EXPECT_FALSE(is_closed(polylines[0]));
    EXPECT_NEAR(polylines[0].front().lpNorm<Eigen::Infinity>(), 4, 1e-13);
    EXPECT_NEAR(polylines[0].back().lpNorm<Eigen::Infinity>(), 4, 1e-13);
    expect_is_section(polylines, mesh, p, 2.5);
    EXPECT_NEAR(turning_angle(polylines, p, {0, 0, 1}), share * 2 * meshes::pi, 1e-12);
  }
}

TEST(Trace_sphere_section, is_a_circle_inside_one_face_where_the_sphere_is_that_small)
{
  const Mesh mesh = meshes::icosphere<Mesh>(0);
  for(auto f : faces(mesh))
  {
    const auto query = location<Mesh>(f, 0.3, 0.3, 0.4);
    for(double radius : {1e-6, 0.01, 0.25})
    {
      const auto polylines = section(query, mesh, radius);
      ASSERT_EQ(polylines.size(), 1u);
      EXPECT_TRUE(is_closed(polylines[0]));
      expect_is_section(polylines, mesh, point_of(mesh, query), radius);
      const double rounding = 1e-15;
      EXPECT_LE(length(polylines[0]), 2 * meshes::pi * radius + rounding);
      EXPECT_GE(length(polylines[0]), 2 * meshes::pi * radius * chord_share);
      EXPECT_NEAR(turning_angle(polylines, point_of(mesh, query), face_normal(mesh, f)), 2 * meshes::pi, 1e-9);
    }
  }
}

TEST(Trace_sphere_section, leaves_other_components_out)
{
  Mesh mesh = meshes::plane<Mesh>(4, 0.5);
  const Mesh above = meshes::moved(mesh, [](const Vector& p) { return Vector(p.x(), p.y(), 0.1); });
  CGAL::copy_face_graph(above, mesh);
  for(double z : {0., 0.1})
  {
    const auto polylines = section(vertex_at(mesh, {0, 0, z}), mesh, 1.2);
    ASSERT_EQ(polylines.size(), 1u);
    for(const Vector& q : polylines[0])
      EXPECT_NEAR(q.z(), z, 1e-15);
  }
}

TEST(Trace_sphere_section, leaves_another_fold_out_unless_it_is_connected_within_the_ball)
{
  // A strip that turns back on itself at x = 4, a tenth above.
  const Mesh mesh = meshes::patch<Mesh>(
    16, 8, [](int i, int j) { return i <= 8 ? Vector(0.5 * i, 0.5 * j, 0) : Vector(0.5 * (16 - i), 0.5 * j, 0.1); });
  const auto far = section(vertex_at(mesh, {2, 2, 0}), mesh, 1.2);
  ASSERT_EQ(far.size(), 1u);
  EXPECT_TRUE(is_closed(far[0]));
  for(const Vector& q : far[0])
    EXPECT_NEAR(q.z(), 0, 1e-15);

  const Vector p(3.5, 2, 0);
  const auto near = section(vertex_at(mesh, p), mesh, 1.2);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_TRUE(is_closed(near[0]));
  expect_is_section(near, mesh, p, 1.2);
  EXPECT_TRUE(std::any_of(near[0].begin(), near[0].end(), [](const Vector& q) { return q.z() > 0.05; }));
}

TEST(Trace_sphere_section, is_two_loops_around_a_cylinder_thinner_than_the_sphere)
{
  const Mesh mesh = meshes::cylinder<Mesh>(0.2, 4, 16, 40);
  const Vector p = meshes::point(mesh, vertex_at(mesh, {0.2, 0, 2}));
  const auto polylines = section(vertex_at(mesh, p), mesh, 1);
  ASSERT_EQ(polylines.size(), 2u);
  expect_is_section(polylines, mesh, p, 1);
  double sides = 1;
  for(const Polyline& loop : polylines)
  {
    EXPECT_TRUE(is_closed(loop));
    EXPECT_NEAR(length(loop), 2 * meshes::pi * 0.2, 0.05);
    const double side = loop[0].z() > 2 ? -1 : 1; // the surface inside is on their left, so they run contrarily
    EXPECT_NEAR(turning_angle({loop}, {0, 0, 2}, {0, 0, side}), 2 * meshes::pi, 1e-9);
    sides *= side;
  }
  EXPECT_EQ(sides, -1);
}

TEST(Trace_sphere_section, is_empty_where_all_is_inside)
{
  const Mesh mesh = meshes::icosphere<Mesh>(1, 0.3);
  EXPECT_TRUE(section(*vertices(mesh).begin(), mesh, 1).empty());
  EXPECT_TRUE(section(*vertices(mesh).begin(), mesh, 1e6).empty());
  Mesh with_isolated = mesh;
  EXPECT_TRUE(section(with_isolated.add_vertex(Kernel::Point_3(0, 0, 0)), with_isolated, 0.1).empty());
}

TEST(Trace_sphere_section, scales_with_the_mesh_to_the_last_bit)
{
  const Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(2), 0.03, 6);
  const auto expected = section(*vertices(mesh).begin(), mesh, 0.7);
  for(int exponent : {-300, 1, 300})
  {
    const double scale = std::ldexp(1., exponent);
    const Mesh scaled = meshes::moved(mesh, [&](const Vector& p) { return Vector(scale * p); });
    auto polylines = section(*vertices(mesh).begin(), scaled, 0.7 * scale);
    for(Polyline& points : polylines)
      for(Vector& q : points)
        q /= scale;
    EXPECT_EQ(polylines, expected);
  }
}

TEST(Trace_sphere_section, ends_on_faces_without_area_and_points_that_are_none)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for(const Vector& bad : {Vector(nan, 0, 0), Vector(infinity, 0, 0), Vector(1e308, 1e308, -1e308)})
  {
    Mesh mesh = meshes::plane<Mesh>(3);
    const auto spoilt = vertex_at(mesh, {1, 1, 0});
    mesh.point(spoilt) = Kernel::Point_3(bad.x(), bad.y(), bad.z());
    for(auto v : vertices(mesh))
      section(v, mesh, 1.5); // what comes out is another matter
  }
  // All vertices of a row in one place, so that the faces between are without area: the section runs past them.
  const Mesh mesh = meshes::moved(
    meshes::plane<Mesh>(5), [](const Vector& p) { return p.x() == 1 && std::abs(p.y()) < 3 ? Vector(1, 0, 0) : p; });
  for(const Vector& p : {Vector(-1, 0, 0), Vector(0, 1, 0), Vector(3, 1, 0)})
    for(double radius : {0.9, 1.7, 2.3})
    {
      const auto polylines = section(vertex_at(mesh, p), mesh, radius);
      for(const Polyline& points : polylines)
        for(const Vector& q : points)
          EXPECT_NEAR((q - p).norm(), radius, 1e-12);
      EXPECT_NEAR(turning_angle(polylines, p, {0, 0, 1}), length_inside_square(p, radius, 5) / radius, 1e-3);
    }
}

TEST(Trace_sphere_section, refuses_what_it_cannot_work_with)
{
  Mesh mesh = meshes::icosphere<Mesh>(1);
  const auto v = *vertices(mesh).begin();
  const auto f = *faces(mesh).begin();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { section(v, mesh, 0); }, {"geodesic_radius is 0", "positive"});
  expect_refused([&] { section(v, mesh, -0.5); }, {"geodesic_radius is -0.5"});
  expect_refused([&] { section(v, mesh, nan); }, {"geodesic_radius is", "nan"});
  expect_refused([&] { section(Mesh::null_vertex(), mesh, 1); }, {"query is the null vertex"});
  expect_refused([&] { section(location<Mesh>(Mesh::null_face(), 1, 0, 0), mesh, 1); }, {"query is at the null face"});
  expect_refused([&] { section(location<Mesh>(f, 0.5, 0.75, 0.5), mesh, 1); }, {"query", "(0.5, 0.75, 0.5)"});

  const auto radii = mesh.add_property_map<Mesh::Vertex_index, double>("v:radius", -0.5).first;
  expect_refused([&] { Spider::trace_sphere_section(v, mesh, geodesic_radius(radii)); }, {"geodesic_radius is -0.5"});

  Mesh quads;
  CGAL::make_quad(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                  Kernel::Point_3(0, 1, 0), quads);
  expect_refused([&] { section(*vertices(quads).begin(), quads, 1); }, {"tmesh has a face that is not a triangle"});
}

} // namespace
