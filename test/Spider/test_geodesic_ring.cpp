// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spider/geodesic_ring.h>

#include "tracing.h"

namespace {

using namespace tracing;
using Spider::parameters::geodesic_radius;

template <typename Mesh>
class Geodesic_ring : public ::testing::Test
{};
TYPED_TEST_SUITE(Geodesic_ring, Mesh_types, );

template <typename Query, typename Mesh, typename NamedParameters>
auto ring(const Query& query, const Vector& normal, const Mesh& mesh, const NamedParameters& np)
{
  std::vector<typename Spider::Limb_3<Mesh>::Point_3> points;
  Spider::geodesic_ring(query, kernel_vector(normal), mesh, std::back_inserter(points), np);
  return points;
}

TYPED_TEST(Geodesic_ring, is_the_ends_of_the_limbs_in_their_order)
{
  const auto mesh = meshes::jittered(meshes::torus<TypeParam>(1, 0.4, 20, 12), 0.03, 1);
  const auto np = geodesic_radius(0.7).number_of_directions(8);
  const auto compare = [&](const auto& query) {
    std::vector<Spider::Limb_3<TypeParam>> limbs;
    const Vector n(0.2, 0.1, 1);
    Spider::trace_limbs(query, kernel_vector(n), mesh, std::back_inserter(limbs), np);
    const auto points = ring(query, n, mesh, np);
    ASSERT_EQ(points.size(), 16u);
    ASSERT_EQ(limbs.size(), 16u);
    for(std::size_t i = 0; i < points.size(); ++i)
      EXPECT_EQ(points[i], limbs[i].polyline.back());
  };
  compare(vertex_at(mesh, {1, 0, 0.4}));
  compare(location<TypeParam>(*std::next(faces(mesh).begin(), 5), 0.2, 0.3, 0.5));
}

TEST(Geodesic_ring, is_a_circle_on_a_plane_and_a_square_at_its_border)
{
  const Mesh mesh = meshes::plane<Mesh>(4);
  const auto v = vertex_at(mesh, {0, 0, 0});
  for(const auto& q : ring(v, {0, 0, 1}, mesh, geodesic_radius(3.5)))
    EXPECT_NEAR(meshes::vector(q).norm(), 3.5, 1e-13);
  for(const auto& q : ring(v, {0, 0, 1}, mesh, geodesic_radius(100)))
    EXPECT_NEAR(meshes::vector(q).lpNorm<Eigen::Infinity>(), 4, 1e-13);
}

TEST(Geodesic_ring, leaves_the_output_iterator_behind_the_last_point)
{
  const Mesh mesh = meshes::plane<Mesh>(2);
  std::vector<Kernel::Point_3> points(10);
  const auto behind = Spider::geodesic_ring(vertex_at(mesh, {0, 0, 0}), Kernel::Vector_3(0, 0, 1), mesh, points.begin(),
                                            geodesic_radius(1).number_of_directions(4));
  EXPECT_EQ(behind - points.begin(), 8);
}

TEST(Geodesic_ring, refuses_what_it_cannot_work_with)
{
  const Mesh mesh = meshes::icosphere<Mesh>(1);
  const auto v = *vertices(mesh).begin();
  expect_refused([&] { ring(v, {0, 0, 0}, mesh, geodesic_radius(1)); }, {"normal is 0 0 0"});
  expect_refused([&] { ring(v, {0, 0, 1}, mesh, geodesic_radius(0)); }, {"geodesic_radius is 0"});
  expect_refused(
    [&] {
      ring(v, {0, 0, 1}, mesh, geodesic_radius(1).number_of_directions(5));
    },
    {"number_of_directions is 5"});
}

} // namespace
