// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../estimators/Rusinkiewicz_2004.h"
#include "test_meshes.h"

#include <gtest/gtest.h>

using namespace CGAL::Spider::benchmark;
using namespace CGAL::Spider::benchmark::test;

// The normals of a sphere of radius R change by 1/R times the edge, and Max's averages are such normals: exact on any
// triangulation of a sphere.
TEST(Rusinkiewicz_2004, IsExactOnAnySphere)
{
  const double radius = 3;
  std::mt19937 random(1);
  Mesh mesh = make_sphere(2, radius);
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const auto noise = [&] { return 0.3 * (double(random()) / double(std::mt19937::max()) - 0.5); };
    const double dx = noise(), dy = noise(), dz = noise();
    const Vector moved = mesh.point(v) - Point(0, 0, 0) + Vector(dx, dy, dz);
    mesh.point(v) = Point(0, 0, 0) + radius * normalized(moved);
  }
  for(const Estimate& e : estimates(Rusinkiewicz_2004(), mesh))
  {
    EXPECT_NEAR(e.min_curvature, 1 / radius, 1e-13);
    EXPECT_NEAR(e.max_curvature, 1 / radius, 1e-13);
  }
}

TEST(Rusinkiewicz_2004, IsExactOnACylinderWithItsNormals)
{
  const int cells = 12;
  const double radius = 2;
  const Mesh mesh = make_cylinder(cells, radius);
  std::vector<Vector> normals;
  for(Mesh::Vertex_index v : mesh.vertices())
    normals.push_back(normalized(Vector(mesh.point(v).x(), 0, mesh.point(v).z())));
  std::vector<Estimate> all;
  Rusinkiewicz_2004().estimate_from_normals(mesh, normals, all);
  for(const Estimate& e : all) // the border too
  {
    EXPECT_NEAR(e.max_curvature, 1 / radius, 1e-13);
    EXPECT_NEAR(e.min_curvature, 0, 1e-13);
    EXPECT_NEAR(line_angle(e.min_direction, Vector(0, 1, 0)), 0, 1e-12);
  }
}

// Finite differences: exact normals of a curved graph give second order in the middle of a symmetric star.
TEST(Rusinkiewicz_2004, ConvergesOnASaddleWithItsNormals)
{
  const double a = 1, b = -2;
  const auto error = [&](int cells) {
    const Mesh mesh = make_graph(cells, [&](double x, double y) { return (a * x * x + b * y * y) / 2; });
    std::vector<Vector> normals;
    for(Mesh::Vertex_index v : mesh.vertices())
      normals.push_back(normalized(Vector(-a * mesh.point(v).x(), -b * mesh.point(v).y(), 1)));
    std::vector<Estimate> all;
    Rusinkiewicz_2004().estimate_from_normals(mesh, normals, all);
    const Estimate e = all[middle_vertex(cells).idx()];
    return std::abs(e.min_curvature + a) + std::abs(e.max_curvature + b);
  };
  EXPECT_NEAR(order(error(20), error(40)), 2, 0.1);
}

// A face alone: its tensor is the least-squares fit to three sides, which three normals of one tensor meet exactly.
TEST(Rusinkiewicz_2004, FitsTheTensorOfOneFace)
{
  Mesh mesh;
  const auto v = add_points(mesh, {Point(0, 0, 0), Point(1, 0, 0), Point(0.3, 0.8, 0)});
  mesh.add_face(v[0], v[1], v[2]);
  const double uu = 0.4, uv = -0.1, vv = -0.2;
  std::vector<Vector> normals;
  for(Mesh::Vertex_index w : v)
  {
    const double x = mesh.point(w).x(), y = mesh.point(w).y();
    normals.emplace_back(uu * x + uv * y, uv * x + vv * y, 1); // not unit: the fit is linear
  }
  std::vector<Estimate> all;
  Rusinkiewicz_2004().estimate_from_normals(mesh, normals, all);
  const Estimate expected = principal_estimate(Tangent_frame(Vector(0, 0, 1)), {uu, uv, vv}); // at the first vertex
  EXPECT_NEAR(all[0].mean_curvature(), expected.mean_curvature(), 1e-14);
  EXPECT_NEAR(all[0].max_curvature, expected.max_curvature, 1e-14);
}

// Corner weights: two flat faces with different tensors meet at a vertex in the ratio of their nearest areas.
TEST(Rusinkiewicz_2004, WeighsFacesByTheirNearestArea)
{
  Mesh mesh;
  const auto v = add_points(mesh, {Point(0, 0, 0), Point(1, 0, 0), Point(0, 3, 0), Point(-2, 0, 0)});
  const auto first = mesh.add_face(v[0], v[1], v[2]), second = mesh.add_face(v[0], v[2], v[3]);
  const double k = 0.1; // the right face alone bends, along x
  std::vector<Vector> normals(4, Vector(0, 0, 1));
  normals[1] = Vector(k, 0, 1);
  std::vector<Estimate> all;
  Rusinkiewicz_2004().estimate_from_normals(mesh, normals, all);
  double weights[2] = {0, 0};
  for(int i = 0; i < 3; ++i)
  {
    const Face_geometry one(mesh, first), other(mesh, second);
    weights[0] += one.vertices[i] == v[0] ? one.nearest_areas()[i] : 0;
    weights[1] += other.vertices[i] == v[0] ? other.nearest_areas()[i] : 0;
  }
  EXPECT_DOUBLE_EQ(weights[0], 0.75); // both faces have their right angle there: half of each
  EXPECT_DOUBLE_EQ(weights[1], 1.5);
  EXPECT_NEAR(all[0].mean_curvature(), k / 2 * weights[0] / (weights[0] + weights[1]), 1e-14);
}
