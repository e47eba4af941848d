// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../estimators/Goldfeather_Interrante_2004.h"
#include "../measures.h"
#include "test_meshes.h"

#include <gtest/gtest.h>

using namespace CGAL::Spider::benchmark;
using namespace CGAL::Spider::benchmark::test;

namespace {

using Neighbourhood = Goldfeather_Interrante_2004::Neighbourhood;

// What is fitted: second and third derivatives at the origin of a cubic graph without a slope there.
struct Cubic
{
  double xx = 1.5, xy = 0.4, yy = -0.7, xxx = 0.5, xxy = -0.3, xyy = 0.8, yyy = 0.2;

  double operator()(double x, double y) const
  {
    return xx / 2 * x * x + xy * x * y + yy / 2 * y * y + xxx * x * x * x + xxy * x * x * y + xyy * x * y * y +
           yyy * y * y * y;
  }
  Vector normal(double x, double y) const
  {
    const double fx = xx * x + xy * y + 3 * xxx * x * x + 2 * xxy * x * y + xyy * y * y;
    const double fy = xy * x + yy * y + xxy * x * x + 2 * xyy * x * y + 3 * yyy * y * y;
    return normalized(Vector(-fx, -fy, 1));
  }
};

std::vector<Estimate> with_normals(Neighbourhood neighbourhood, const Mesh& mesh, const std::vector<Vector>& normals,
                                   double radius)
{
  std::vector<Estimate> all;
  Goldfeather_Interrante_2004(neighbourhood).estimate_from_normals(mesh, normals, radius, all);
  return all;
}

} // namespace

// The paper's point: third order is in the model, so that a cubic with its normals is met exactly, in any units.
TEST(Goldfeather_Interrante_2004, IsExactOnACubicGraphWithItsNormals)
{
  const Cubic cubic;
  const int cells = 10;
  const Tangent_tensor bend{-cubic.xx, -cubic.xy, -cubic.yy};
  for(double unit : {1., 1000.})
    for(Neighbourhood neighbourhood : {Neighbourhood::one_ring, Neighbourhood::ball})
    {
      Mesh mesh = make_graph(cells, cubic, 0.3); // around a symmetric star the third order would cancel
      mesh.point(middle_vertex(cells)) = Point(0, 0, 0);
      std::vector<Vector> normals;
      for(Mesh::Vertex_index v : mesh.vertices())
      {
        Point& p = mesh.point(v);
        normals.push_back(cubic.normal(p.x(), p.y()));
        p = Point(unit * p.x(), unit * p.y(), unit * p.z());
      }
      const Estimate e = with_normals(neighbourhood, mesh, normals, 0.5 * unit)[middle_vertex(cells).idx()];
      const Tangent_frame frame(Vector(0, 0, 1));
      const auto form = [&](const Vector& a, const Vector& b) {
        return bend.uu * a.x() * b.x() + bend.uv * (a.x() * b.y() + a.y() * b.x()) + bend.vv * a.y() * b.y();
      };
      const Estimate exact =
        principal_estimate(frame, {form(frame.u, frame.u), form(frame.u, frame.v), form(frame.v, frame.v)});
      EXPECT_NEAR(e.min_curvature * unit, exact.min_curvature, 1e-11);
      EXPECT_NEAR(e.max_curvature * unit, exact.max_curvature, 1e-11);
      EXPECT_NEAR(line_angle(e.max_direction, exact.max_direction), 0, 1e-11);
    }
}

TEST(Goldfeather_Interrante_2004, ConvergesOnASphere)
{
  const double radius = 2;
  const auto error = [&](Neighbourhood neighbourhood, unsigned int subdivisions) {
    const Mesh mesh = make_sphere(subdivisions, radius);
    std::vector<Vector> normals;
    for(Mesh::Vertex_index v : mesh.vertices())
      normals.push_back(normalized(mesh.point(v) - Point(0, 0, 0)));
    const double three_edges = radius * 3 * std::sqrt(4 * CGAL_PI / double(mesh.num_vertices()));
    return worst_error(with_normals(neighbourhood, mesh, normals, three_edges), mesh.vertices(), 1 / radius, mean);
  };
  for(Neighbourhood neighbourhood : {Neighbourhood::one_ring, Neighbourhood::ball})
    EXPECT_NEAR(order(error(neighbourhood, 3), error(neighbourhood, 4)), 2, 0.1); // measured: 2.00, 2.04
}

// In the one-ring the averaged normals are those of a sphere, so that nothing is lost there; see test_vertex_normals.
TEST(Goldfeather_Interrante_2004, NeedsNoNormalsOnASphere)
{
  const Mesh mesh = make_sphere(3);
  std::vector<Vector> normals;
  for(Mesh::Vertex_index v : mesh.vertices())
    normals.push_back(normalized(mesh.point(v) - Point(0, 0, 0)));
  const auto given = with_normals(Neighbourhood::one_ring, mesh, normals, 0);
  const auto averaged = estimates(Goldfeather_Interrante_2004(Neighbourhood::one_ring), mesh);
  for(Mesh::Vertex_index v : mesh.vertices())
    EXPECT_NEAR(given[v.idx()].mean_curvature(), averaged[v.idx()].mean_curvature(), 1e-10);
}

// Without noise the error falls with the square of the radius, on any tessellation: a cubic neglects the same fourth
// order that a quadric does. Normals of first order, as those weighted by area are, would make it grow instead.
TEST(Goldfeather_Interrante_2004, FallsWithTheSquareOfTheRadiusOnIrregularMeshes)
{
  Recipe recipe;
  recipe.shape = "sphere";
  recipe.tessellation = Tessellation::irregular;
  recipe.number_of_vertices = 4000;
  const Surface surface = make_surface(recipe);
  const auto error = [&](double radius_in_edges) {
    const double radius = radius_in_edges * surface.mean_edge_length;
    const auto found = estimates(Goldfeather_Interrante_2004(Neighbourhood::ball), surface.mesh, radius);
    return compare(found, surface.truth, interior_vertices(surface, radius), surface.rms_curvature).H.mean;
  };
  EXPECT_NEAR(order(error(6), error(3)), 2, 0.2); // measured: 2.10; with normals weighted by area: 0.90
  EXPECT_LT(error(6), 0.06);                      // measured: 0.044
}

TEST(Goldfeather_Interrante_2004, SaysNothingWithTooFewNeighbours)
{
  Mesh mesh;
  const auto v = add_points(mesh, {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)});
  mesh.add_face(v[0], v[1], v[2]); // six equations for seven unknowns
  for(Neighbourhood neighbourhood : {Neighbourhood::one_ring, Neighbourhood::ball})
    for(const Estimate& e : estimates(Goldfeather_Interrante_2004(neighbourhood), mesh, 5))
    {
      EXPECT_TRUE(std::isnan(e.max_curvature));
      EXPECT_NEAR(e.normal.z(), 1, 1e-15);
    }
}
