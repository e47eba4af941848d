// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../estimators/shared/vertex_normals.h"
#include "test_meshes.h"

#include <gtest/gtest.h>

using namespace CGAL::Spider::benchmark;
using namespace CGAL::Spider::benchmark::test;

namespace {

Mesh triangle(const Point& a, const Point& b, const Point& c)
{
  Mesh mesh;
  const auto v = add_points(mesh, {a, b, c});
  mesh.add_face(v[0], v[1], v[2]);
  return mesh;
}

Face_geometry geometry_of(const Mesh& mesh) { return Face_geometry(mesh, *mesh.faces().begin()); }

// The share of a fine regular sampling of the face that is nearest to a corner.
double sampled_nearest_share(const Mesh& mesh, const Face_geometry& face, int corner)
{
  constexpr int steps = 600;
  const Point p[3] = {mesh.point(face.vertices[0]), mesh.point(face.vertices[1]), mesh.point(face.vertices[2])};
  int nearest = 0, all = 0;
  for(int i = 0; i < steps; ++i)
    for(int j = 0; i + j < steps; ++j, ++all)
    {
      const double s = (i + 1. / 3) / steps, t = (j + 1. / 3) / steps;
      const Point q = CGAL::barycenter(p[0], 1 - s - t, p[1], s, p[2], t);
      const double own = CGAL::squared_distance(q, p[corner]);
      nearest += own <= CGAL::squared_distance(q, p[next_corner(corner)]) &&
                 own <= CGAL::squared_distance(q, p[previous_corner(corner)]);
    }
  return double(nearest) / all;
}

} // namespace

TEST(Face_geometry, KnowsAnglesAndArea)
{
  const Mesh mesh = triangle(Point(0, 0, 0), Point(2, 0, 0), Point(0, 2, 0));
  const Face_geometry face = geometry_of(mesh);
  EXPECT_DOUBLE_EQ(face.area(), 2);
  EXPECT_GT(face.doubled_area_vector.z(), 0);
  for(int i = 0; i < 3; ++i)
  {
    const bool right = mesh.point(face.vertices[i]) == Point(0, 0, 0);
    EXPECT_DOUBLE_EQ(face.angle(i), right ? CGAL_PI / 2 : CGAL_PI / 4);
    EXPECT_NEAR(face.cotangent(i), right ? 0 : 1, 1e-15);
  }
}

TEST(Face_geometry, NearestAreasAreExact)
{
  const Mesh acute = triangle(Point(0, 0, 0), Point(3, 0, 1), Point(1, 2, 0));
  const Mesh obtuse = triangle(Point(0, 0, 0), Point(4, 0, 0), Point(1, 0.5, 0.5));
  for(const Mesh& mesh : {acute, obtuse})
  {
    const Face_geometry face = geometry_of(mesh);
    const std::array<double, 3> areas = face.nearest_areas();
    EXPECT_NEAR(areas[0] + areas[1] + areas[2], face.area(), 1e-14);
    for(int i = 0; i < 3; ++i)
      EXPECT_NEAR(areas[i] / face.area(), sampled_nearest_share(mesh, face, i), 2e-3); // the sampling's error
  }
  EXPECT_EQ(geometry_of(acute).obtuse_corner(), -1);
  EXPECT_GE(geometry_of(obtuse).obtuse_corner(), 0);
}

// Max 1999: whatever the triangulation, as long as all vertices lie on the sphere.
TEST(Vertex_normals, SphereWeightsAreExactOnASphere)
{
  std::mt19937 random(1);
  Mesh mesh = make_sphere(2);
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const auto noise = [&] { return 0.1 * (double(random()) / double(std::mt19937::max()) - 0.5); };
    const double dx = noise(), dy = noise(), dz = noise();
    const Vector moved = mesh.point(v) - Point(0, 0, 0) + Vector(dx, dy, dz);
    mesh.point(v) = Point(0, 0, 0) + normalized(moved);
  }
  const std::vector<Vector> exact = vertex_normals(mesh, Normal_weight::sphere);
  const std::vector<Vector> by_area = vertex_normals(mesh, Normal_weight::area);
  double worst_by_area = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    EXPECT_NEAR(exact[v.idx()] * (mesh.point(v) - Point(0, 0, 0)), 1, 1e-14);
    worst_by_area = (std::max)(worst_by_area, line_angle(by_area[v.idx()], mesh.point(v) - Point(0, 0, 0)));
  }
  EXPECT_GT(worst_by_area, 0.05); // measured: 0.1
}

TEST(Vertex_normals, AreaWeightsFollowTheArea)
{
  // two faces at a right angle, one of twice the other's area, share the edge from the origin along x
  Mesh mesh;
  const auto v = add_points(mesh, {Point(0, 0, 0), Point(1, 0, 0), Point(0, 2, 0), Point(0, 0, -1)});
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[1], v[0], v[3]);
  const Vector n = vertex_normals(mesh, Normal_weight::area)[v[0].idx()];
  EXPECT_NEAR(n.z(), 2 / std::sqrt(5.), 1e-15);
  EXPECT_NEAR(n.y(), -1 / std::sqrt(5.), 1e-15);
}

TEST(Vertex_normals, AreNaNWhereThereAreNone)
{
  Mesh mesh = triangle(Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0)); // no area
  mesh.add_vertex(Point(0, 0, 5));
  for(Normal_weight weight : {Normal_weight::area, Normal_weight::sphere})
    for(const Vector& normal : vertex_normals(mesh, weight))
      EXPECT_FALSE(is_finite(normal));
}
