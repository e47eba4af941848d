// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: what the caller got wrong is a std::invalid_argument that names the parameter, the value and the remedy,
// in release builds too; what is wrong with a mesh locally is NaN with a status, and never a crash.

#include "estimation.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Spider/estimate_normal.h>
#include <CGAL/Spider/estimate_normal_curvature.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/boost/graph/generators.h>

#include <limits>
#include <map>
#include <stdexcept>

using namespace estimation;
using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// expects a refusal whose text has all of `parts` in it.
template <typename Call>
void expect_refusal(Call&& call, const std::vector<std::string>& parts)
{
  try
  {
    call();
    ADD_FAILURE() << "there was no refusal of " << parts.front();
  }
  catch(const std::invalid_argument& refusal)
  {
    for(const std::string& part : parts)
      EXPECT_NE(std::string(refusal.what()).find(part), std::string::npos) << refusal.what() << " lacks " << part;
  }
}

/// expects single queries and batches alike to refuse.
template <typename NamedParameters>
void expect_refusal_of(const NamedParameters& np, const std::vector<std::string>& parts)
{
  static const Mesh mesh = meshes::icosphere<Mesh>(1);
  expect_refusal([&] { Spider::estimate_curvature(Vertex(0), mesh, np); }, parts);
  expect_refusal([&] { Spider::Curvature_estimator<Mesh, NamedParameters>(mesh, np); }, parts);
}

/// expects that nothing crashes and that every number is there, or NaN with a status that says so.
void expect_no_harm(const Mesh& mesh, double radius)
{
  for_each_setting(radius, [&](const auto& np) {
    for(const Estimate& e : estimates(mesh, np))
      expect_sound(e);
    for(Vertex v : mesh.vertices())
      expect_sound(Spider::estimate_curvature(v, mesh, np));
    for(Mesh::Face_index f : mesh.faces())
      expect_sound(Spider::estimate_curvature(Location(f, {0.25, 0.25, 0.5}), mesh, np));
  });
}

} // namespace

TEST(bad_input, parameters_out_of_their_range_are_refused)
{
  for(double radius : {0., -1., -infinity})
    for_each_setting(radius, [](const auto& np) { expect_refusal_of(np, {"geodesic_radius", "give a positive"}); });
  for_each_setting(-1.5, [](const auto& np) { expect_refusal_of(np, {"geodesic_radius is -1.5"}); });
  for_each_setting(not_a_number, [](const auto& np) { expect_refusal_of(np, {"geodesic_radius is nan", "give"}); });
  for_each_setting(infinity, [](const auto& np) { expect_refusal_of(np, {"geodesic_radius is inf", "give"}); });

  for_each_setting(1., [](const auto& np) {
    expect_refusal_of(np.number_of_directions(0), {"number_of_directions is 0", "give"});
    expect_refusal_of(np.number_of_directions(-2), {"number_of_directions is -2", "give"});
    expect_refusal_of(np.number_of_directions(1 << 20), {"number_of_directions is 1048576", "give"});
    expect_refusal_of(np.polynomial_degree(1), {"polynomial_degree is 1", "give 2, 3 or 4"});
    expect_refusal_of(np.polynomial_degree(5u), {"polynomial_degree is 5", "give 2, 3 or 4"});
    expect_refusal_of(np.resampling_step(0.), {"resampling_step is 0", "give"});
    expect_refusal_of(np.resampling_step(1.5), {"resampling_step is 1.5", "give"});
    expect_refusal_of(np.resampling_step(not_a_number), {"resampling_step is nan", "give"});
    expect_refusal_of(np.convergence_angle(-0.5), {"convergence_angle is -0.5", "give"});
    expect_refusal_of(np.convergence_angle(not_a_number), {"convergence_angle is nan", "give"});
    expect_refusal_of(np.number_of_iterations(0), {"number_of_iterations is 0", "give"});
    expect_refusal_of(np.number_of_iterations(-3), {"number_of_iterations is -3", "give"});
  });
  // Directions are compared in orthogonal pairs.
  expect_refusal_of(params::as_published().geodesic_radius(1.).number_of_directions(7),
                    {"number_of_directions is 7", "give an even number"});
}

TEST(bad_input, a_mesh_that_is_not_triangulated_is_refused)
{
  Mesh cube;
  CGAL::make_hexahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                        Kernel::Point_3(0, 1, 0), Kernel::Point_3(0, 1, 1), Kernel::Point_3(0, 0, 1),
                        Kernel::Point_3(1, 0, 1), Kernel::Point_3(1, 1, 1), cube);
  for_each_setting(1., [&](const auto& np) {
    const std::vector<std::string> parts = {"tmesh", "not a triangle", "triangulate_faces()"};
    expect_refusal([&] { Spider::estimate_curvature(Vertex(0), cube, np); }, parts);
    expect_refusal([&] { Spider::estimate_normal(Vertex(0), cube, np); }, parts);
    expect_refusal([&] { estimates(cube, np); }, parts);
  });
}

TEST(bad_input, queries_that_are_not_on_the_mesh_are_refused)
{
  const Mesh mesh = meshes::icosphere<Mesh>(1);
  for_each_setting(1., [&](const auto& np) {
    const auto refuse = [&](const auto& query, const std::vector<std::string>& parts) {
      expect_refusal([&] { Spider::estimate_curvature(query, mesh, np); }, parts);
      expect_refusal([&] { Spider::estimate_normal(query, mesh, np); }, parts);
    };
    refuse(Mesh::null_vertex(), {"query", "give a vertex of tmesh"});
    refuse(Location(Mesh::null_face(), {1, 0, 0}), {"query", "give a face of tmesh"});
    const Mesh::Face_index f(0);
    refuse(Location(f, {0.5, 0.5, 0.5}), {"query", "0.5", "sum to 1"});
    refuse(Location(f, {1.5, -0.25, -0.25}), {"query", "1.5", "must not be negative"});
    refuse(Location(f, {not_a_number, 0, 0}), {"query", "nan", "locate()"});
  });
}

TEST(bad_input, normals_and_directions_without_a_direction_are_refused)
{
  using Triple = Kernel::Vector_3;
  const Mesh mesh = meshes::icosphere<Mesh>(1);
  const auto refuse = [&](const Triple& normal, const Triple& direction, const std::vector<std::string>& parts) {
    expect_refusal(
      [&] { Spider::estimate_normal_curvature(Vertex(0), normal, direction, mesh, params::geodesic_radius(1.)); },
      parts);
  };
  refuse(Triple(0, 0, 0), Triple(1, 0, 0), {"normal is 0 0 0", "give"});
  refuse(Triple(0, not_a_number, 0), Triple(1, 0, 0), {"normal", "nan", "give"});
  refuse(Triple(0, 0, 1), Triple(0, 0, 0), {"direction is 0 0 0", "give"});
  refuse(Triple(0, 0, 1), Triple(0, 0, -7), {"direction is  0  0 -7", "not parallel to the normal"});
  refuse(Triple(0, 0, 1), Triple(infinity, 0, 0), {"direction", "inf", "give"});
}

TEST(bad_input, radii_of_a_map_that_are_no_lengths_spoil_their_vertices_alone)
{
  const Mesh mesh = meshes::icosphere<Mesh>(2);
  std::map<Vertex, double> radii;
  for(Vertex v : mesh.vertices())
    radii[v] = 0.7;
  radii[Vertex(3)] = -1;
  radii[Vertex(50)] = 0;
  radii[Vertex(70)] = not_a_number;
  radii[Vertex(90)] = infinity;
  for_each_setting(boost::make_assoc_property_map(radii), [&](const auto& np) {
    const std::vector<Estimate> all = estimates(mesh, np);
    for(std::size_t i = 0; i < all.size(); ++i)
    {
      expect_sound(all[i]);
      EXPECT_EQ(all[i].status, i == 3 || i == 50 || i == 70 || i == 90 ? Spider::insufficient : Spider::ok) << i;
    }
  });
}

TEST(bad_input, an_isolated_vertex_is_nan_and_isolated)
{
  Mesh mesh = meshes::icosphere<Mesh>(2);
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(0, 0, 0));
  for_each_setting(0.7, [&](const auto& np) {
    const std::vector<Estimate> all = estimates(mesh, np);
    for(Vertex v : mesh.vertices())
      EXPECT_EQ(all[v.idx()].status, v == isolated ? Spider::isolated : Spider::ok);
    const Estimate e = Spider::estimate_curvature(isolated, mesh, np);
    EXPECT_EQ(e.status, Spider::isolated);
    EXPECT_EQ(e.coverage, 0);
    EXPECT_TRUE(vector(e.normal).array().isNaN().all());
  });
  // A mesh of vertices alone has no edge from which to take a radius.
  Mesh points;
  points.add_vertex(Kernel::Point_3(1, 2, 3));
  EXPECT_EQ(Spider::estimate_curvature(Vertex(0), points).status, Spider::isolated);
}

TEST(bad_input, a_single_triangle_has_a_normal_and_no_harm_is_done)
{
  const Mesh triangle = meshes::from_soup<Mesh>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  for(double radius : {0.1, 1., 10.})
    expect_no_harm(triangle, radius);
  for_each_setting(0.1, [&](const auto& np) {
    const Estimate inside = Spider::estimate_curvature(Location(Mesh::Face_index(0), {0.3, 0.3, 0.4}), triangle, np);
    EXPECT_EQ(inside.status, Spider::ok);
    EXPECT_NEAR(inside.curvedness(), 0, 1e-12);
    EXPECT_LE(angle(vector(Spider::estimate_curvature(Vertex(0), triangle, np).normal), Vector(0, 0, 1)), 1e-12);
  });
  // In a corner of 45° or less there is no orthogonal pair of directions.
  const Mesh thin = meshes::from_soup<Mesh>({{0, 0, 0}, {1, 0, 0}, {1, 0.2, 0}}, {{0, 1, 2}});
  const Estimate corner = Spider::estimate_curvature(Vertex(0), thin, params::as_published().geodesic_radius(0.3));
  EXPECT_EQ(corner.status, Spider::insufficient);
  EXPECT_TRUE(std::isnan(corner.min_curvature) && std::isnan(corner.max_curvature));
  EXPECT_LE(angle(vector(corner.normal), Vector(0, 0, 1)), 1e-12);
  EXPECT_LT(corner.coverage, 0.1);
}

TEST(bad_input, faces_without_area_do_no_harm)
{
  // A cap, a needle and a point among good faces, and faces that lie all on a line.
  expect_no_harm(meshes::from_soup<Mesh>({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}},
                                         {{0, 1, 3}, {1, 2, 3}, {0, 2, 1}, {0, 4, 2}}),
                 0.8);
  expect_no_harm(meshes::from_soup<Mesh>({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2}, {2, 1, 3}}), 1);
  expect_no_harm(meshes::from_soup<Mesh>({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}), 1);
}

TEST(bad_input, vertices_that_coincide_do_no_harm)
{
  Mesh mesh = meshes::icosphere<Mesh>(2);
  mesh.point(Vertex(1)) = mesh.point(mesh.source(mesh.halfedge(Vertex(1))));
  mesh.point(Vertex(60)) = mesh.point(mesh.source(mesh.halfedge(Vertex(60))));
  expect_no_harm(mesh, 0.7);
  // All in one place, so even the default radius is zero.
  for(Vertex v : mesh.vertices())
    mesh.point(v) = Kernel::Point_3(1, 2, 3);
  for(Vertex v : mesh.vertices())
  {
    const Estimate e = Spider::estimate_curvature(v, mesh);
    expect_sound(e);
    EXPECT_EQ(e.status, Spider::insufficient);
  }
}

TEST(bad_input, folded_stars_do_no_harm)
{
  expect_no_harm(meshes::jittered(meshes::icosphere<Mesh>(2), 0.6, 8), 0.7); // edges are 0.3 long
  expect_no_harm(meshes::jittered(meshes::plane<Mesh>(4), 1.5, 8), 3);
}

TEST(bad_input, coordinates_that_are_no_numbers_spoil_what_is_near_alone)
{
  const Mesh good = meshes::icosphere<Mesh>(2);
  for(double bad : {not_a_number, infinity})
  {
    Mesh mesh = good;
    mesh.point(Vertex(0)) = Kernel::Point_3(bad, 0, 0);
    expect_no_harm(mesh, 0.5);
    for_each_setting(0.5, [&](const auto& np) {
      const std::vector<Estimate> all = estimates(mesh, np);
      EXPECT_FALSE(all[0].is_valid());
      for(Vertex v : mesh.vertices())
        if((meshes::point(good, v) - meshes::point(good, Vertex(0))).norm() > 1.5)
        {
          EXPECT_EQ(all[v.idx()].status, Spider::ok);
        }
    });
  }
}

TEST(bad_input, huge_and_tiny_meshes_are_as_good_as_others)
{
  const Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(2), 0.02, 2);
  std::vector<std::vector<Estimate>> expected;
  for_each_setting(0.7, [&](const auto& np) { expected.push_back(estimates(mesh, np)); });
  for(double factor : {1e-140, 1e-30, 1e30, 1e140})
  {
    const Mesh scaled = meshes::moved(mesh, [&](const Vector& p) { return Vector(factor * p); });
    std::size_t setting = 0;
    for_each_setting(factor * 0.7, [&](const auto& np) {
      const std::vector<Estimate> got = estimates(scaled, np);
      for(std::size_t i = 0; i < got.size(); ++i)
      {
        Estimate unscaled = got[i];
        unscaled.min_curvature *= factor;
        unscaled.max_curvature *= factor;
        unscaled.residual /= factor;
        expect_same(unscaled, expected[setting][i], 1e-9);
      }
      ++setting;
    });
  }
  for(double factor : {1e-320, 1e-300, 1e300})
    expect_no_harm(meshes::moved(mesh, [&](const Vector& p) { return Vector(factor * p); }), factor * 0.7);
}

TEST(bad_input, far_from_the_origin_digits_are_lost_and_nothing_else)
{
  const Mesh far =
    meshes::moved(meshes::icosphere<Mesh>(3), [](const Vector& p) { return Vector(p + Vector(1e6, -1e6, 1e6)); });
  for_each_setting(0.5, [&](const auto& np) {
    for(const Estimate& e : estimates(far, np))
    {
      EXPECT_EQ(e.status, Spider::ok);
      EXPECT_NEAR(e.mean_curvature(), 1, 0.1);
    }
  });
  expect_no_harm(
    meshes::moved(meshes::icosphere<Mesh>(1), [](const Vector& p) { return Vector(p + Vector(1e17, 0, 0)); }), 0.5);
}
