// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Spider/estimate_normal.h>

using namespace estimation;

namespace {

constexpr Spider::First_normal kinds[] = {Spider::incident_faces, Spider::neighbourhood, Spider::sphere_section};

template <typename Query>
Vector normal(const Query& query, const Mesh& mesh, Spider::First_normal kind, double radius)
{
  return vector(Spider::estimate_normal(query, mesh, params::geodesic_radius(radius).first_normal(kind)));
}

} // namespace

TEST(estimate_normal, points_outwards_on_a_sphere)
{
  const Mesh sphere = meshes::icosphere<Mesh>(4);
  for(Spider::First_normal kind : kinds)
    for(std::size_t i = 0; i < sphere.number_of_vertices(); i += 37)
    {
      const Vertex v(static_cast<Mesh::size_type>(i));
      const Vector n = normal(v, sphere, kind, 0.3);
      EXPECT_NEAR(n.norm(), 1, 1e-14);
      EXPECT_LE(angle(n, meshes::point(sphere, v)), 0.02) << kind; // measured 0.015, edges being 0.07 long
    }
}

TEST(estimate_normal, is_exact_on_a_plane_whatever_its_triangles)
{
  const Vector n = Vector(1, 2, -3).normalized(), u = n.unitOrthogonal(), v = n.cross(u);
  const Mesh plane = meshes::moved(meshes::moved(meshes::jittered(meshes::plane<Mesh>(6), 0.3, 1),
                                                 [](const Vector& p) { return Vector(p.x(), p.y(), 0); }),
                                   [&](const Vector& p) { return Vector(p.x() * u + p.y() * v + 5 * n); });
  for(Spider::First_normal kind : kinds)
    for(Vertex vertex : plane.vertices())
      EXPECT_LE(angle(normal(vertex, plane, kind, 2.5), n), 1e-12) << kind;
}

TEST(estimate_normal, answers_anywhere_in_a_face)
{
  using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;
  const Mesh sphere = meshes::icosphere<Mesh>(4);
  for(Spider::First_normal kind : kinds)
    for(std::size_t i = 0; i < sphere.number_of_faces(); i += 151)
      for(const auto& weights : {std::array<double, 3>{0.2, 0.3, 0.5}, std::array<double, 3>{0.6, 0, 0.4}})
      {
        const Location location(Mesh::Face_index(static_cast<Mesh::size_type>(i)), weights);
        const Vector p = vector(CGAL::Polygon_mesh_processing::construct_point(location, sphere));
        // The faces' own normals are off by the angle to the middle of the face: measured 0.018.
        EXPECT_LE(angle(normal(location, sphere, kind, 0.3), p), 0.03) << kind;
      }
}

TEST(estimate_normal, at_a_corner_of_a_face_is_that_of_the_vertex)
{
  using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;
  const Mesh mesh = irregular_noisy_meshes().front().second;
  const Mesh::Face_index f(100);
  const Vertex v = mesh.source(mesh.halfedge(f));
  for(Spider::First_normal kind : kinds)
    EXPECT_LE(angle(normal(Location(f, {1, 0, 0}), mesh, kind, 0.4), normal(v, mesh, kind, 0.4)), 1e-14);
}

TEST(estimate_normal, of_a_larger_neighbourhood_withstands_noise)
{
  const Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(4), 0.02, 7); // edges are 0.07 long
  const auto mean_error = [&](Spider::First_normal kind) {
    double sum = 0;
    for(Vertex v : mesh.vertices())
      sum += angle(normal(v, mesh, kind, 0.3), meshes::point(mesh, v));
    return sum / mesh.number_of_vertices();
  };
  const double small = mean_error(Spider::incident_faces);
  EXPECT_LE(mean_error(Spider::neighbourhood), 0.35 * small);  // measured 0.22
  EXPECT_LE(mean_error(Spider::sphere_section), 0.35 * small); // measured 0.22
}

TEST(estimate_normal, of_a_sphere_section_falls_back_where_the_sphere_holds_the_component)
{
  const Mesh mesh = irregular_noisy_meshes().front().second;
  for(std::size_t i = 0; i < mesh.number_of_vertices(); i += 41)
  {
    const Vertex v(static_cast<Mesh::size_type>(i));
    EXPECT_LE(angle(normal(v, mesh, Spider::sphere_section, 3), normal(v, mesh, Spider::neighbourhood, 3)), 1e-14);
  }
}

TEST(estimate_normal, is_nan_where_there_is_no_face_or_none_with_an_area)
{
  Mesh mesh = meshes::from_soup<Mesh>({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(5, 5, 5));
  for(Spider::First_normal kind : kinds)
  {
    EXPECT_TRUE(normal(isolated, mesh, kind, 1).array().isNaN().all());
    EXPECT_TRUE(normal(Vertex(0), mesh, kind, 5).array().isNaN().all());
  }
}

TEST(estimate_normal, given_normals_are_interpolated_and_made_unit)
{
  using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;
  const Mesh mesh = meshes::plane<Mesh>(2);
  const auto normals = boost::make_static_property_map<Vertex>(Kernel::Vector_3(0, 3, 4));
  const auto np = params::geodesic_radius(1).vertex_normal_map(normals);
  EXPECT_LE((vector(Spider::estimate_normal(Vertex(12), mesh, np)) - Vector(0, 0.6, 0.8)).norm(), 1e-15);
  const Location location(Mesh::Face_index(5), {0.25, 0.25, 0.5});
  EXPECT_LE((vector(Spider::estimate_normal(location, mesh, np)) - Vector(0, 0.6, 0.8)).norm(), 1e-15);
}
