// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Spider/estimate_curvature.h>

#include <map>
#include <type_traits>

using namespace estimation;

namespace {

Mesh noisy_saddle() { return meshes::jittered(meshes::saddle<Mesh>(10, 0.1, 1.5, -0.5), 0.02, 4); }

const Vertex centre(220); // 21 * 10 + 10

template <typename NamedParameters>
Estimate at_centre(const Mesh& mesh, const NamedParameters& np)
{
  return Spider::estimate_curvature(centre, mesh, np);
}

template <typename Base, typename Changed>
void expect_effect(const Mesh& mesh, const Base& base, const Changed& changed)
{
  const Estimate a = at_centre(mesh, base), b = at_centre(mesh, changed);
  ASSERT_TRUE(a.is_valid() && b.is_valid());
  EXPECT_TRUE(a.min_curvature != b.min_curvature || a.max_curvature != b.max_curvature);
}

} // namespace

TEST(parameters, chain_in_any_order_and_before_those_of_cgal)
{
  const Mesh mesh = noisy_saddle();
  const auto vpm = get(CGAL::vertex_point, mesh);
  const Estimate a = at_centre(mesh, params::as_published().geodesic_radius(0.4).polynomial_degree(3));
  const Estimate b = at_centre(mesh, params::polynomial_degree(3u)
                                       .first_normal(Spider::sphere_section)
                                       .geodesic_radius(0.4)
                                       .estimator(Spider::section_fit)
                                       .resampling_step(0.1)
                                       .number_of_directions(64)
                                       .convergence_angle(1e-3)
                                       .number_of_iterations(10)
                                       .vertex_point_map(vpm)
                                       .geom_traits(Kernel()));
  expect_identical(a, b);
}

TEST(parameters, each_has_an_effect)
{
  const Mesh mesh = noisy_saddle();
  const auto base = params::as_published().geodesic_radius(0.4);
  expect_effect(mesh, base, params::as_published().geodesic_radius(0.3));
  expect_effect(mesh, base, base.number_of_directions(6));
  expect_effect(mesh, base, base.polynomial_degree(3));
  expect_effect(mesh, base, base.resampling_step(0.2));
  expect_effect(mesh, base, base.number_of_iterations(1));
  expect_effect(mesh, base, base.convergence_angle(3));
  expect_effect(
    mesh, base.number_of_iterations(1),
    params::as_published().geodesic_radius(0.4).first_normal(Spider::incident_faces).number_of_iterations(1));
  expect_effect(
    mesh, base.number_of_iterations(1),
    params::as_published().geodesic_radius(0.4).first_normal(Spider::neighbourhood).number_of_iterations(1));
}

TEST(parameters, what_is_chained_to_as_published_overrides_it)
{
  const Mesh mesh = noisy_saddle();
  expect_identical(at_centre(mesh, params::as_published().number_of_directions(8).geodesic_radius(0.4)),
                   at_centre(mesh, params::estimator(Spider::section_fit)
                                     .first_normal(Spider::sphere_section)
                                     .number_of_directions(8)
                                     .geodesic_radius(0.4)));
}

TEST(parameters, are_read_from_numbers_of_any_type)
{
  const Mesh mesh = noisy_saddle();
  const Estimate expected = at_centre(mesh, params::geodesic_radius(0.5).number_of_directions(32));
  expect_identical(at_centre(mesh, params::geodesic_radius(0.5f).number_of_directions(32l)), expected);
  expect_identical(at_centre(mesh, params::geodesic_radius(CGAL::Gmpq(1, 2)).number_of_directions(std::size_t(32))),
                   expected);
  expect_identical(at_centre(mesh, params::geodesic_radius(1)), at_centre(mesh, params::geodesic_radius(1.)));
}

TEST(parameters, the_default_radius_is_four_mean_edge_lengths)
{
  const Mesh mesh = noisy_saddle();
  const double radius = 4 * meshes::mean_edge_length(mesh);
  expect_same(at_centre(mesh, CGAL::parameters::default_values()), at_centre(mesh, params::geodesic_radius(radius)),
              1e-11);
  expect_same(Spider::estimate_curvature(centre, mesh), at_centre(mesh, params::geodesic_radius(radius)), 1e-11);
}

TEST(parameters, the_radius_may_be_a_property_map)
{
  const Mesh mesh = noisy_saddle();
  std::map<Vertex, double> radii;
  for(Vertex v : mesh.vertices())
    radii[v] = 0.3 + 0.01 * (v.idx() % 11);
  const auto radius_map = boost::make_assoc_property_map(radii);
  for_each_setting(radius_map, [&](const auto& np) {
    const std::vector<Estimate> by_map = estimates(mesh, np);
    for(std::size_t i = 150; i < 160; ++i)
    {
      const Vertex v(static_cast<Mesh::size_type>(i));
      expect_same(Spider::estimate_curvature(v, mesh, np), by_map[i], 1e-12);
    }
  });
  // The first normal's averaging passes are those of each vertex, so given normals make the comparison exact.
  std::map<Vertex, Kernel::Vector_3> normals;
  for(Vertex v : mesh.vertices())
    normals[v] = Kernel::Vector_3(0.1, 0.2, 1);
  const auto normal_map = boost::make_assoc_property_map(normals);
  expect_identical(at_centre(mesh, params::geodesic_radius(radius_map).vertex_normal_map(normal_map)),
                   at_centre(mesh, params::geodesic_radius(radii[centre]).vertex_normal_map(normal_map)));
}

TEST(parameters, a_radius_map_is_interpolated_in_faces)
{
  using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;
  const Mesh mesh = noisy_saddle();
  std::map<Vertex, double> radii;
  std::map<Vertex, Kernel::Vector_3> normals;
  for(Vertex v : mesh.vertices())
  {
    radii[v] = 0.3 + 0.01 * (v.idx() % 11);
    normals[v] = Kernel::Vector_3(0, 0, 2);
  }
  const auto normal_map = boost::make_assoc_property_map(normals);
  const Mesh::Face_index f = mesh.face(mesh.halfedge(centre));
  const std::array<double, 3> weights{0.5, 0.2, 0.3};
  double radius = 0;
  int i = 0;
  for(Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) // starts at the target of the halfedge
    radius += weights[(i++ + 1) % 3] * radii[v];
  std::vector<Estimate> by_map, by_number;
  for_each_setting(boost::make_assoc_property_map(radii), [&](const auto& np) {
    by_map.push_back(Spider::estimate_curvature(Location(f, weights), mesh, np.vertex_normal_map(normal_map)));
  });
  for_each_setting(radius, [&](const auto& np) {
    by_number.push_back(Spider::estimate_curvature(Location(f, weights), mesh, np.vertex_normal_map(normal_map)));
  });
  for(std::size_t k = 0; k < by_map.size(); ++k)
  {
    ASSERT_TRUE(by_map[k].is_valid());
    expect_same(by_map[k], by_number[k], 1e-11);
  }
}

TEST(parameters, given_normals_may_be_of_another_kernel_and_of_any_length)
{
  using Other = CGAL::Exact_predicates_inexact_constructions_kernel;
  const Mesh mesh = noisy_saddle();
  std::map<Vertex, Kernel::Vector_3> unit;
  std::map<Vertex, Other::Vector_3> any_length;
  for(Vertex v : mesh.vertices())
  {
    const Kernel::Point_3& p = mesh.point(v);
    unit[v] = Kernel::Vector_3(-1.5 * p.x(), 0.5 * p.y(), 1);
    unit[v] /= std::sqrt(unit[v].squared_length());
    any_length[v] = Other::Vector_3(8 * unit[v].x(), 8 * unit[v].y(), 8 * unit[v].z()); // exactly
  }
  for_each_setting(0.4, [&](const auto& np) {
    const Estimate expected = at_centre(mesh, np.vertex_normal_map(boost::make_assoc_property_map(unit)));
    const Estimate got = at_centre(mesh, np.vertex_normal_map(boost::make_assoc_property_map(any_length)));
    ASSERT_TRUE(expected.is_valid());
    expect_same(got, expected, 1e-12);
  });
}

TEST(parameters, given_normals_decide_the_side)
{
  const Mesh mesh = noisy_saddle();
  std::map<Vertex, Kernel::Vector_3> up, down;
  for(Vertex v : mesh.vertices())
  {
    up[v] = Kernel::Vector_3(0, 0, 1);
    down[v] = Kernel::Vector_3(0, 0, -1);
  }
  for_each_setting(0.4, [&](const auto& np) {
    const Estimate a = at_centre(mesh, np.vertex_normal_map(boost::make_assoc_property_map(up)));
    const Estimate b = at_centre(mesh, np.vertex_normal_map(boost::make_assoc_property_map(down)));
    EXPECT_GT(a.normal.z(), 0.9);
    EXPECT_LT(b.normal.z(), -0.9);
    EXPECT_NEAR(a.min_curvature, -b.max_curvature, 1e-9);
  });
}

TEST(parameters, geom_traits_chooses_the_kernel_of_the_results)
{
  using Narrow = CGAL::Simple_cartesian<float>;
  const Mesh mesh = noisy_saddle();
  for_each_setting(0.4, [&](const auto& np) {
    const auto narrow = Spider::estimate_curvature(centre, mesh, np.geom_traits(Narrow()));
    static_assert(std::is_same<decltype(narrow), const Spider::Curvature_estimate_3<Narrow>>::value, "");
    EXPECT_EQ(narrow.max_curvature, static_cast<float>(at_centre(mesh, np).max_curvature));
  });
}
