// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Spider/estimate_curvature.h>

#include <map>

using namespace estimation;
using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;

// The errors of the fits to exact surfaces at these radii are a few percent; what is tested here is signs, order and
// directions. test_convergence.cpp has the digits.

TEST(estimate_curvature, is_positive_on_a_sphere_that_faces_outwards)
{
  for(double R : {0.5, 3.})
    for_each_setting(0.4 * R, [&](const auto& np) {
      const Mesh sphere = meshes::icosphere<Mesh>(4, R);
      for(std::size_t i = 0; i < sphere.number_of_vertices(); i += 101)
      {
        const Vertex v(static_cast<Mesh::size_type>(i));
        const Estimate e = Spider::estimate_curvature(v, sphere, np);
        expect_sound(e);
        EXPECT_EQ(e.status, Spider::ok);
        EXPECT_NEAR(e.coverage, 1, 1e-12);
        EXPECT_NEAR(e.min_curvature * R, 1, 0.05);
        EXPECT_NEAR(e.max_curvature * R, 1, 0.05);
        EXPECT_LE(angle(vector(e.normal), meshes::point(sphere, v)), 0.01);
        EXPECT_LE(e.residual, 0.01 * R);
      }
    });
}

TEST(estimate_curvature, is_negative_on_a_sphere_that_faces_inwards)
{
  Mesh sphere = meshes::icosphere<Mesh>(4);
  CGAL::Polygon_mesh_processing::reverse_face_orientations(sphere);
  for_each_setting(0.4, [&](const auto& np) {
    const Estimate e = Spider::estimate_curvature(Vertex(100), sphere, np);
    EXPECT_NEAR(e.min_curvature, -1, 0.05);
    EXPECT_NEAR(e.max_curvature, -1, 0.05);
    EXPECT_LE(angle(vector(e.normal), -meshes::point(sphere, Vertex(100))), 0.01);
  });
}

TEST(estimate_curvature, has_both_signs_on_a_saddle)
{
  // z = (2x² - y²) / 2 bends up, towards the normal, along x: curvature -2 there and 1 along y.
  const Mesh saddle = meshes::saddle<Mesh>(20, 0.02, 2, -1);
  for_each_setting(0.15, [&](const auto& np) {
    const Estimate e = Spider::estimate_curvature(Vertex(41 * 20 + 20), saddle, np);
    expect_sound(e);
    EXPECT_NEAR(e.min_curvature, -2, 0.1);
    EXPECT_NEAR(e.max_curvature, 1, 0.05);
    const double spacing = meshes::pi / 64;
    EXPECT_LE(angle_of_lines(vector(e.min_direction), Vector(1, 0, 0)), spacing);
    EXPECT_LE(angle_of_lines(vector(e.max_direction), Vector(0, 1, 0)), spacing);
    EXPECT_LE(angle(vector(e.normal), Vector(0, 0, 1)), 0.01);
    EXPECT_LT(e.Gaussian_curvature(), 0);
  });
}

TEST(estimate_curvature, on_a_cylinder_is_that_of_the_circle_around_and_none_along)
{
  const double R = 2;
  const Mesh cylinder = meshes::cylinder<Mesh>(R, 4, 80, 24);
  for_each_setting(0.8, [&](const auto& np) {
    for(unsigned row : {3u, 47u})
    {
      const Vertex v(25 * row + 12);
      const Vector outwards = Vector(meshes::point(cylinder, v).x(), meshes::point(cylinder, v).y(), 0).normalized();
      const Estimate e = Spider::estimate_curvature(v, cylinder, np);
      expect_sound(e);
      EXPECT_EQ(e.status, Spider::ok);
      EXPECT_NEAR(e.min_curvature, 0, 0.02 / R);
      EXPECT_NEAR(e.max_curvature, 1 / R, 0.05 / R);
      EXPECT_LE(angle_of_lines(vector(e.min_direction), Vector(0, 0, 1)), meshes::pi / 64);
      EXPECT_LE(angle(vector(e.normal), outwards), 0.01);
    }
  });
}

TEST(estimate_curvature, tells_the_outer_half_of_a_torus_from_the_inner)
{
  const double R = 1, tube = 0.4;
  const Mesh torus = meshes::torus<Mesh>(R, tube, 240, 96);
  for_each_setting(0.16, [&](const auto& np) {
    const Estimate outer = Spider::estimate_curvature(Vertex(0), torus, np);
    EXPECT_NEAR(outer.min_curvature, 1 / (R + tube), 0.08 / (R + tube));
    EXPECT_NEAR(outer.max_curvature, 1 / tube, 0.08 / tube);
    EXPECT_LE(angle_of_lines(vector(outer.min_direction), Vector(0, 1, 0)), meshes::pi / 64);
    const Estimate inner = Spider::estimate_curvature(Vertex(48), torus, np);
    EXPECT_NEAR(inner.min_curvature, -1 / (R - tube), 0.08 / (R - tube));
    EXPECT_NEAR(inner.max_curvature, 1 / tube, 0.08 / tube);
  });
}

TEST(estimate_curvature, is_sound_everywhere_on_irregular_noisy_meshes)
{
  for(const auto& [name, mesh] : irregular_noisy_meshes())
    for_each_setting(0.5, [&, &name = name, &mesh = mesh](const auto& np) {
      SCOPED_TRACE(name);
      for(const Estimate& e : estimates(mesh, np))
        expect_sound(e);
    });
}

TEST(estimate_curvature, at_a_corner_of_a_face_is_that_of_the_vertex)
{
  const Mesh mesh = irregular_noisy_meshes().front().second;
  const Mesh::Face_index f(200);
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  for_each_setting(0.4, [&](const auto& np) {
    expect_identical(Spider::estimate_curvature(Location(f, {1, 0, 0}), mesh, np),
                     Spider::estimate_curvature(mesh.source(h), mesh, np));
    expect_identical(Spider::estimate_curvature(Location(f, {0, 1, 0}), mesh, np),
                     Spider::estimate_curvature(mesh.target(h), mesh, np));
  });
}

TEST(estimate_curvature, on_an_edge_is_the_same_from_both_sides)
{
  const Mesh mesh = irregular_noisy_meshes().front().second;
  const Mesh::Halfedge_index h(150), o = mesh.opposite(h);
  const auto on = [&](Mesh::Halfedge_index side, double weight_of_source) {
    Location location(mesh.face(side), {0, 0, 0});
    int i = 0;
    for(Mesh::Halfedge_index at : CGAL::halfedges_around_face(mesh.halfedge(mesh.face(side)), mesh))
    {
      if(at == side)
      {
        location.second[i] = weight_of_source;
        location.second[(i + 1) % 3] = 1 - weight_of_source;
      }
      ++i;
    }
    return location;
  };
  for_each_setting(0.4, [&](const auto& np) {
    const Estimate e = Spider::estimate_curvature(on(h, 0.25), mesh, np);
    EXPECT_TRUE(e.is_valid());
    expect_same(e, Spider::estimate_curvature(on(o, 0.75), mesh, np), 1e-11);
  });
}

TEST(estimate_curvature, answers_at_the_point_and_not_at_the_corners_of_its_face)
{
  const Mesh sphere = meshes::icosphere<Mesh>(4);
  for_each_setting(0.4, [&](const auto& np) {
    for(const Kernel::Point_3& p : {Kernel::Point_3(1, 2, 3), Kernel::Point_3(-3, 1, 0), Kernel::Point_3(0.1, -1, 1)})
    {
      const Location location = CGAL::Polygon_mesh_processing::locate(p, sphere);
      const Estimate e = Spider::estimate_curvature(location, sphere, np);
      expect_sound(e);
      EXPECT_NEAR(e.mean_curvature(), 1, 0.05);
      EXPECT_LE(angle(vector(e.normal), vector(p)), 0.04); // measured 0.021: the facet's own normal pulls
    }
  });
}

TEST(estimate_curvature, rights_a_tilted_normal_by_iterating)
{
  const Mesh sphere = meshes::icosphere<Mesh>(4);
  const Vertex v(0);
  const Vector truth = meshes::point(sphere, v).normalized();
  const Vector tilted = truth + 0.3 * truth.unitOrthogonal();
  const auto normals = boost::make_static_property_map<Vertex>(Kernel::Vector_3(tilted.x(), tilted.y(), tilted.z()));
  for_each_setting(0.4, [&](const auto& np) {
    const Estimate once = Spider::estimate_curvature(
      v, sphere, np.convergence_angle(1e-3).vertex_normal_map(normals).number_of_iterations(1));
    const Estimate often = Spider::estimate_curvature(
      v, sphere, np.convergence_angle(1e-3).vertex_normal_map(normals).number_of_iterations(10));
    EXPECT_LE(angle(vector(once.normal), truth), 0.2); // from 0.29, measured 0.157
    EXPECT_LE(angle(vector(often.normal), truth), 0.002);
    EXPECT_NEAR(often.mean_curvature(), 1, 0.05);
  });
}

TEST(estimate_curvature, finds_the_residual_that_noise_leaves)
{
  const auto residual = [](double noise, const auto& np) {
    const Mesh mesh = meshes::jittered(meshes::plane<Mesh>(15, 0.1), noise, 9);
    double sum = 0;
    int count = 0;
    for(Vertex v : mesh.vertices())
      if(std::abs(mesh.point(v).x()) < 0.5 && std::abs(mesh.point(v).y()) < 0.5)
      {
        sum += Spider::estimate_curvature(v, mesh, np).residual;
        ++count;
      }
    return sum / count;
  };
  for_each_setting(0.6, [&](const auto& np) {
    EXPECT_LE(residual(0, np), 1e-15);
    const double small = residual(0.01, np), large = residual(0.02, np);
    EXPECT_NEAR(large / small, 2, 0.2);
    // Uniform noise in ±0.01 has a root mean square of 0.0058, of which linear interpolation between vertices keeps
    // about two thirds.
    EXPECT_NEAR(small, 0.0038, 0.0012);
  });
}
