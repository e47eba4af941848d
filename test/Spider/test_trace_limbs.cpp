// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spider/trace_limbs.h>

#include "tracing.h"

namespace {

using namespace tracing;
using Spider::parameters::geodesic_radius;

template <typename Mesh>
class Trace_limbs : public ::testing::Test
{};
TYPED_TEST_SUITE(Trace_limbs, Mesh_types, );

template <typename Query, typename Mesh, typename NamedParameters>
std::vector<Spider::Limb_3<Mesh>> limbs(const Query& query, const Vector& normal, const Mesh& mesh,
                                        const NamedParameters& np)
{
  std::vector<Spider::Limb_3<Mesh>> result;
  Spider::trace_limbs(query, kernel_vector(normal), mesh, std::back_inserter(result), np);
  return result;
}

/// returns the direction from a limb's start, in the plane orthogonal to the normal, in which it goes on a smooth mesh.
template <typename Limb>
Vector direction_of(const Limb& limb, const Vector& normal)
{
  const Vector first = meshes::vector(limb.polyline[1]) - meshes::vector(limb.polyline[0]);
  return (first - first.dot(normal) * normal).normalized();
}

TYPED_TEST(Trace_limbs, are_two_for_each_direction_at_regular_angles_counter_clockwise_about_the_normal)
{
  const auto mesh = meshes::jittered(meshes::saddle<TypeParam>(4, 0.25), 0.03, 1);
  const auto v = vertex_at(mesh, {0, 0, 0});
  const auto query = location<TypeParam>(*std::next(faces(mesh).begin(), 70), 0.2, 0.3, 0.5);
  const Vector n = Vector(0.1, -0.2, 1).normalized();
  for(int directions : {2, 6, 64})
  {
    const auto np = geodesic_radius(0.4).number_of_directions(directions);
    const auto expect_regular = [&](const auto& spider, const Vector& normal) {
      ASSERT_EQ(spider.size(), 2u * directions);
      for(std::size_t i = 0; i < spider.size(); ++i)
      {
        EXPECT_EQ(spider[i].end, Spider::radius_reached);
        const Vector a = direction_of(spider[i], normal);
        const Vector b = direction_of(spider[(i + 1) % spider.size()], normal);
        EXPECT_NEAR(std::atan2(normal.dot(a.cross(b)), a.dot(b)), meshes::pi / directions, 1e-12);
      }
    };
    expect_regular(limbs(v, n, mesh, np), n);
    expect_regular(limbs(query, n, mesh, np), n);
    expect_regular(limbs(v, -n, mesh, np), -n);
  }
}

TYPED_TEST(Trace_limbs, are_those_that_are_traced_one_by_one)
{
  const auto mesh = meshes::jittered(meshes::torus<TypeParam>(1, 0.4, 20, 12), 0.03, 2);
  const auto query = location<TypeParam>(*std::next(faces(mesh).begin(), 50), 0.5, 0.5, 0);
  const Vector n = face_normal(mesh, query.first);
  for(const auto& limb : limbs(query, n, mesh, geodesic_radius(0.7).number_of_directions(8)))
  {
    const Vector d = direction_of(limb, n);
    const auto same = Spider::trace_limb(query, kernel_vector(n), kernel_vector(d), mesh, geodesic_radius(0.7));
    EXPECT_EQ(same.end, limb.end);
    EXPECT_LE(distance(polyline(same.polyline), polyline(limb.polyline)), 1e-12);
    expect_is_limb(limb, mesh, point_of(mesh, query), n, d, 0.7);
  }
}

TEST(Trace_limbs, are_128_of_four_mean_edges_unless_told_otherwise)
{
  const Mesh mesh = meshes::icosphere<Mesh>(3);
  std::vector<Spider::Limb_3<Mesh>> spider;
  Spider::trace_limbs(*vertices(mesh).begin(), Kernel::Vector_3(0, 1, 0), mesh, std::back_inserter(spider));
  EXPECT_EQ(spider.size(), 128u);
  for(const auto& limb : spider)
    EXPECT_NEAR(limb.length, 4 * meshes::mean_edge_length(mesh), 1e-14);
}

TEST(Trace_limbs, are_as_many_as_the_radius_asks_for_with_surface_fit)
{
  const Mesh mesh = meshes::icosphere<Mesh>(3);
  const double edge = meshes::mean_edge_length(mesh);
  const auto number_of_limbs = [&](double radius) {
    return limbs(*vertices(mesh).begin(), Vector(0, 1, 0), mesh, geodesic_radius(radius).estimator(Spider::surface_fit))
      .size();
  };
  EXPECT_EQ(number_of_limbs(2 * edge), 2 * 16u);
  EXPECT_EQ(number_of_limbs(7.99 * edge), 2 * 20u); // 2.5 for each edge length
}

TEST(Trace_limbs, start_at_the_same_place_of_a_mesh_that_moves)
{
  const Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(2), 0.05, 3);
  const auto v = *vertices(mesh).begin();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.1, Vector(3, -2, 1).normalized()).toRotationMatrix();
  const Mesh there = meshes::moved(mesh, [&](const Vector& p) { return Vector(turn * p); });
  const Vector n = vertex_normal(mesh, v);
  const auto np = geodesic_radius(0.8).number_of_directions(4);
  const auto here = limbs(v, n, mesh, np), moved = limbs(v, turn * n, there, np);
  for(std::size_t i = 0; i < here.size(); ++i)
    EXPECT_LE((meshes::vector(moved[i].polyline.back()) - turn * meshes::vector(here[i].polyline.back())).norm(),
              1e-13);
}

TEST(Trace_limbs, are_of_one_point_at_an_isolated_vertex)
{
  Mesh mesh = meshes::plane<Mesh>(1);
  const auto v = mesh.add_vertex(Kernel::Point_3(1, 2, 3));
  const auto spider = limbs(v, {0, 0, 1}, mesh, geodesic_radius(1).number_of_directions(2));
  ASSERT_EQ(spider.size(), 4u);
  for(const auto& limb : spider)
    EXPECT_EQ(limb.polyline, std::vector<Kernel::Point_3>{mesh.point(v)});
}

TEST(Trace_limbs, refuses_what_it_cannot_work_with)
{
  const Mesh mesh = meshes::icosphere<Mesh>(1);
  const auto v = *vertices(mesh).begin();
  const Vector n(0, 0, 1);
  expect_refused([&] { limbs(v, {0, 0, 0}, mesh, geodesic_radius(1)); }, {"normal is 0 0 0"});
  expect_refused([&] { limbs(v, n, mesh, geodesic_radius(-1)); }, {"geodesic_radius is -1"});
  expect_refused([&] { limbs(Mesh::null_vertex(), n, mesh, geodesic_radius(1)); }, {"query is the null vertex"});
  for(int bad : {0, -4, 1, 3, 65538})
    expect_refused([&] { limbs(v, n, mesh, geodesic_radius(1).number_of_directions(bad)); },
                   {"number_of_directions is " + std::to_string(bad), "even"});
}

} // namespace
