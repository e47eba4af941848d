// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: with `limb_elongation_map` limbs reach the radius along the vectors given, and as many times less across
// as these are long. Nothing else changes.

#include "estimation.h"

#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>

#include <limits>
#include <stdexcept>

using namespace estimation;

namespace {

using Vector_3 = Kernel::Vector_3;
using Vector_map = Mesh::Property_map<Vertex, Vector_3>;

Vector_map same_at_all_vertices(Mesh& mesh, const char* name, const Vector_3& vector)
{
  const auto map = mesh.add_property_map<Vertex, Vector_3>(name).first; // the same one the next time
  for(Vertex v : mesh.vertices())
    map[v] = vector;
  return map;
}

/// returns the estimate at the middle of a mesh's graph of a height, of 41 x 41 vertices.
Estimate estimate_at_middle(Mesh& mesh, double radius, const Vector_3& elongation)
{
  const auto elongations = same_at_all_vertices(mesh, "v:elongation", elongation);
  const auto normals = same_at_all_vertices(mesh, "v:normal", Vector_3(0, 0, 1));
  const Vertex middle(41 * 20 + 20);
  return Spider::estimate_curvature(
    middle, mesh, params::geodesic_radius(radius).limb_elongation_map(elongations).vertex_normal_map(normals));
}

} // namespace

TEST(limb_elongation, limbs_see_nothing_beyond_the_ellipse)
{
  // A plane up to where a limb leaves the last face that it reaches, and a slope beyond.
  const double radius = 12, length = 2, one_face = std::sqrt(2.);
  const double x_end = radius / length + one_face, y_end = radius + one_face;
  Mesh mesh = meshes::height_field<Mesh>(20, 1, [&](double x, double y) {
    return std::max({0., std::abs(x) - x_end, std::abs(y) - y_end});
  });
  const Estimate inside = estimate_at_middle(mesh, radius, Vector_3(0, length, 0));
  EXPECT_EQ(inside.status, Spider::ok);
  EXPECT_NEAR(inside.coverage, 1, 1e-12); // of what limbs were to reach
  EXPECT_LE(std::hypot(inside.min_curvature, inside.max_curvature), 1e-12);
  const Estimate across = estimate_at_middle(mesh, radius, Vector_3(length, 0, 0));
  EXPECT_GT(std::hypot(across.min_curvature, across.max_curvature), 1e-3);
}

TEST(limb_elongation, blurs_less_across_and_as_much_along)
{
  const double k = 0.35, amplitude = 1;
  Mesh mesh = meshes::height_field<Mesh>(20, 1, [&](double x, double) { return amplitude * std::cos(k * x); });
  const double exact = amplitude * k * k / 2, radius = 9;
  const auto error = [&](const Vector_3& elongation) {
    return std::abs(estimate_at_middle(mesh, radius, elongation).mean_curvature() - exact);
  };
  const double of_disc = error(Vector_3(0, 0, 0)), along = error(Vector_3(0, 2, 0)), across = error(Vector_3(2, 0, 0));
  EXPECT_LT(along, of_disc / 4) << along << ' ' << of_disc << ' ' << across;
  EXPECT_GT(across, of_disc / 2);
}

TEST(limb_elongation, of_discs_changes_nothing)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(auto& [name, mesh] : irregular_noisy_meshes())
  {
    SCOPED_TRACE(name);
    Mesh copy = mesh;
    const double radius = 4 * meshes::mean_edge_length(mesh);
    const auto plain = estimates(mesh, params::geodesic_radius(radius), 7);
    const Vector_3 discs[] = {{0, 0, 0}, {0, -1, 0}, {0.5, 0.5, 0.5}, {nan, 2, 0}, {infinity, 0, 0}};
    for(const Vector_3& disc : discs)
    {
      const auto map = copy.add_property_map<Vertex, Vector_3>("v:elongation").first;
      for(Vertex v : copy.vertices())
        map[v] = disc;
      const auto listed = estimates(copy, params::geodesic_radius(radius).limb_elongation_map(map), 7);
      ASSERT_EQ(listed.size(), plain.size());
      for(std::size_t i = 0; i < plain.size(); ++i)
        expect_same(listed[i], plain[i]);
    }
  }
}

TEST(limb_elongation, is_the_same_for_one_query_and_for_many)
{
  for(auto& [name, mesh] : irregular_noisy_meshes())
  {
    SCOPED_TRACE(name);
    Mesh copy = mesh;
    const auto map = copy.add_property_map<Vertex, Vector_3>("v:elongation").first;
    for(Vertex v : copy.vertices())
      map[v] = (1 + 0.01 * (v.idx() % 150)) * Vector_3(0.6, 0, 0.8);
    const auto np = params::geodesic_radius(4 * meshes::mean_edge_length(mesh)).limb_elongation_map(map);
    const Spider::Curvature_estimator estimator(copy, np);
    const auto expect_near = [](const Estimate& a, const Estimate& b) {
      EXPECT_EQ(a.status, b.status);
      if(a.is_valid())
      {
        EXPECT_NEAR(a.mean_curvature(), b.mean_curvature(), 1e-12 * (1 + std::abs(b.curvedness())));
      }
    };
    int number = 0;
    for(auto f : copy.faces())
      if(++number % 50 == 0)
      {
        const auto location = std::make_pair(f, std::array<double, 3>{0.5, 0.3, 0.2});
        expect_near(Spider::estimate_curvature(location, copy, np), estimator(location));
        const Vertex v = source(halfedge(f, copy), copy);
        const Estimate at_vertex = Spider::estimate_curvature(v, copy, np);
        expect_near(at_vertex, estimator(v));
        expect_near(at_vertex, estimator(std::make_pair(f, std::array<double, 3>{1, 0, 0})));
      }
  }
}

TEST(limb_elongation, goes_with_several_radii)
{
  Mesh mesh = meshes::jittered(meshes::saddle<Mesh>(20, 0.1), 0.03, 1);
  const auto elongations = same_at_all_vertices(mesh, "v:elongation", Vector_3(1.5, 0.5, 0));
  const auto normals = same_at_all_vertices(mesh, "v:normal", Vector_3(0, 0, 1)); // the same first normal for all
  const std::vector<double> radii = {0.3, 0.5, 0.8};
  const Vertex middle(41 * 20 + 20);
  const auto all = Spider::estimate_curvature(
    middle, mesh,
    params::geodesic_radii(radii).limb_elongation_map(elongations).number_of_directions(24).vertex_normal_map(normals));
  ASSERT_EQ(all.size(), radii.size());
  for(std::size_t k = 0; k < radii.size(); ++k)
    expect_same(all[k], Spider::estimate_curvature(middle, mesh,
                                                   params::geodesic_radius(radii[k])
                                                     .limb_elongation_map(elongations)
                                                     .number_of_directions(24)
                                                     .vertex_normal_map(normals)));
}

TEST(limb_elongation, is_refused_by_section_fit)
{
  Mesh mesh = meshes::plane<Mesh>(5);
  const auto elongations = same_at_all_vertices(mesh, "v:elongation", Vector_3(0, 2, 0));
  const auto discs = same_at_all_vertices(mesh, "v:disc", Vector_3(0, 0, 0));
  const Vertex middle(60);
  EXPECT_THROW(Spider::estimate_curvature(middle, mesh, params::as_published().limb_elongation_map(elongations)),
               std::invalid_argument);
  EXPECT_NO_THROW(Spider::estimate_curvature(middle, mesh, params::as_published().limb_elongation_map(discs)));
}
