// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../estimators/Jet_fitting.h"
#include "../measures.h"
#include "test_meshes.h"

#include <gtest/gtest.h>

#include <deque>
#include <set>

using namespace CGAL::Spider::benchmark;
using namespace CGAL::Spider::benchmark::test;

namespace {

using Neighbourhood = Jet_fitting::Neighbourhood;

double wavy(double x, double y) { return 0.3 * std::sin(2 * x) * std::cos(3 * y) + 0.2 * x * x; }

// Rings and balls again, by the plainest means.
std::set<Mesh::Vertex_index> plain_rings(const Mesh& mesh, Mesh::Vertex_index centre, std::size_t fewest)
{
  std::set<Mesh::Vertex_index> gathered{centre};
  while(gathered.size() < fewest)
  {
    const std::set<Mesh::Vertex_index> before = gathered;
    for(Mesh::Vertex_index v : before)
      for(Mesh::Vertex_index w : mesh.vertices_around_target(mesh.halfedge(v)))
        gathered.insert(w);
  }
  return gathered;
}

std::set<Mesh::Vertex_index> plain_ball(const Mesh& mesh, Mesh::Vertex_index centre, double radius)
{
  std::set<Mesh::Vertex_index> gathered{centre};
  std::deque<Mesh::Vertex_index> queue{centre};
  for(; !queue.empty(); queue.pop_front())
    for(Mesh::Vertex_index w : mesh.vertices_around_target(mesh.halfedge(queue.front())))
      if(CGAL::squared_distance(mesh.point(centre), mesh.point(w)) <= radius * radius && gathered.insert(w).second)
        queue.push_back(w);
  return gathered;
}

// What CGAL's manual tells a user to do.
Estimate plain_jet(const Mesh& mesh, Mesh::Vertex_index centre, std::set<Mesh::Vertex_index> gathered,
                   std::size_t degree)
{
  std::vector<Point> points{mesh.point(centre)};
  gathered.erase(centre);
  for(Mesh::Vertex_index v : gathered)
    points.push_back(mesh.point(v));
  CGAL::Monge_via_jet_fitting<Kernel> fitting;
  auto form = fitting(points.begin(), points.end(), degree, 2);
  form.comply_wrt_given_normal(Vector(0, 0, 1));
  Estimate estimate;
  estimate.min_curvature = -form.principal_curvatures(0);
  estimate.max_curvature = -form.principal_curvatures(1);
  estimate.max_direction = form.minimal_principal_direction();
  estimate.normal = form.normal_direction();
  return estimate;
}

void expect_same(const Estimate& a, const Estimate& b)
{
  const double rounding = 1e-7; // the points' order differs, and jets of degree 4 are ill-conditioned
  EXPECT_NEAR(a.min_curvature, b.min_curvature, rounding);
  EXPECT_NEAR(a.max_curvature, b.max_curvature, rounding);
  EXPECT_NEAR(line_angle(a.max_direction, b.max_direction), 0, rounding);
  EXPECT_NEAR(a.normal * b.normal, 1, rounding);
}

} // namespace

// Around the middle of a regular grid the neighbourhood is symmetric, so that the fit's axis is the graph's own.
TEST(Jet_fitting, IsExactOnAQuadraticGraph)
{
  const double a = 1.5, b = -0.5; // z = a x^2 / 2 + b y^2 / 2: the curvatures with an upward normal are -a and -b
  const int cells = 20;
  const Mesh mesh = make_graph(cells, [&](double x, double y) { return (a * x * x + b * y * y) / 2; });
  for(const Jet_fitting& jets : {Jet_fitting(2, Neighbourhood::rings), Jet_fitting(2, Neighbourhood::ball),
                                 Jet_fitting(4, Neighbourhood::rings), Jet_fitting(4, Neighbourhood::ball)})
  {
    const Estimate e = estimates(jets, mesh, 0.35)[middle_vertex(cells).idx()];
    EXPECT_NEAR(e.min_curvature, -a, 1e-9) << jets.name();
    EXPECT_NEAR(e.max_curvature, -b, 1e-9) << jets.name();
    EXPECT_NEAR(line_angle(e.min_direction, Vector(1, 0, 0)), 0, 1e-9) << jets.name();
    EXPECT_NEAR(line_angle(e.max_direction, Vector(0, 1, 0)), 0, 1e-9) << jets.name();
    EXPECT_NEAR(e.normal.z(), 1, 1e-12) << jets.name();
  }
}

// Cazals and Pouget: curvatures of a jet of degree d converge with order d - 1; symmetric samples of a sphere gain one.
TEST(Jet_fitting, ConvergesOnASphere)
{
  const double radius = 2;
  const Mesh coarse = make_sphere(3, radius), fine = make_sphere(4, radius);
  for(std::size_t degree : {2, 4})
  {
    const Jet_fitting jets(degree, Neighbourhood::rings);
    const auto error = [&](const Mesh& mesh) {
      return worst_error(estimates(jets, mesh), mesh.vertices(), 1 / radius, mean);
    };
    EXPECT_GT(error(coarse), 0);
    EXPECT_NEAR(order(error(coarse), error(fine)), double(degree), 0.2) << degree; // measured: 1.99, 4.0
  }
}

TEST(Jet_fitting, AgreesWithPlainUseOnTheFewestRings)
{
  const int cells = 16;
  const Mesh mesh = make_graph(cells, wavy, 0.3);
  for(std::size_t degree : {2, 4})
  {
    const std::vector<Estimate> all = estimates(Jet_fitting(degree, Neighbourhood::rings), mesh);
    for(Mesh::Vertex_index v : inner_vertices(cells))
      expect_same(all[v.idx()], plain_jet(mesh, v, plain_rings(mesh, v, (degree + 1) * (degree + 2) / 2), degree));
  }
}

TEST(Jet_fitting, AgreesWithPlainUseOnABall)
{
  const int cells = 16;
  const Mesh mesh = make_graph(cells, wavy, 0.3);
  const double radius = 0.4; // three cells
  for(std::size_t degree : {2, 4})
  {
    const std::vector<Estimate> all = estimates(Jet_fitting(degree, Neighbourhood::ball), mesh, radius);
    for(Mesh::Vertex_index v : inner_vertices(cells))
      expect_same(all[v.idx()], plain_jet(mesh, v, plain_ball(mesh, v, radius), degree));
  }
}

// Under noise the error is the one that least squares must have. On a sphere the mean curvature of a quadric over a
// disc of radius r is twice the slope of z against the squared distance, whose variance over the disc is r^4 / 12; so n
// vertices with noise of the standard deviation a / sqrt(12) give a normally distributed H with the deviation 2 a /
// (r^2 sqrt(n)).
TEST(Jet_fitting, HasTheErrorThatNoiseMustCause)
{
  Recipe recipe;
  recipe.shape = "sphere";
  recipe.number_of_vertices = 4000;
  recipe.noise.amplitude = 1;
  const Surface surface = make_surface(recipe);
  const double a = surface.mean_edge_length, radius = 4 * a;
  const auto found = estimates(Jet_fitting(2, Neighbourhood::ball), surface.mesh, radius);
  const double measured = compare(found, surface.truth, interior_vertices(surface, radius), 1).H.mean;

  const double in_ball =
    double(surface.mesh.number_of_vertices()) * radius * radius / 4; // its share of the unit sphere
  const double deviation = 2 * a / (radius * radius * std::sqrt(in_ball));
  const double mean_over_deviation = std::sqrt(2 / CGAL_PI);
  EXPECT_NEAR(measured / (mean_over_deviation * deviation), 1, 0.1); // measured: 1.05
}

TEST(Jet_fitting, SaysNothingWhereTheMeshIsTooSmall)
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  for(const Estimate& e : estimates(Jet_fitting(2, Neighbourhood::ball), mesh, 10))
    EXPECT_TRUE(std::isnan(e.max_curvature)); // four points for six coefficients
}
