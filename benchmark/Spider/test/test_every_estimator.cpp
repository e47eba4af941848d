// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What all estimators promise alike, whatever the mesh.

#include "../estimators.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <gtest/gtest.h>

using namespace CGAL::Spider::benchmark;
using namespace CGAL::Spider::benchmark::test;

namespace {

bool is_all_nan(const Vector& v) { return std::isnan(v.x()) && std::isnan(v.y()) && std::isnan(v.z()); }

// Values or NaN, never infinite; curvatures in order; directions unit, across each other and across the normal.
void expect_well_formed(const Estimate& e)
{
  ASSERT_EQ(std::isnan(e.min_curvature), std::isnan(e.max_curvature));
  if(!std::isnan(e.min_curvature))
  {
    EXPECT_TRUE(std::isfinite(e.min_curvature));
    EXPECT_LE(e.min_curvature, e.max_curvature);
  }
  for(const Vector& v : {e.min_direction, e.max_direction, e.normal})
  {
    if(!is_all_nan(v))
    {
      EXPECT_NEAR(v.squared_length(), 1, 1e-9);
    }
  }
  if(is_all_nan(e.max_direction) || is_all_nan(e.min_direction))
    return;
  EXPECT_NEAR(e.min_direction * e.max_direction, 0, 1e-9);
}

void expect_well_formed(const Estimator& estimator, const Mesh& mesh, double radius)
{
  const std::vector<Estimate> all = estimates(estimator, mesh, radius);
  ASSERT_EQ(all.size(), mesh.num_vertices());
  for(const Estimate& e : all)
    expect_well_formed(e);
}

std::string name_of(const testing::TestParamInfo<std::size_t>& info) { return all_estimators()[info.param]->name(); }

Mesh transformed(Mesh mesh, const CGAL::Aff_transformation_3<Kernel>& transformation)
{
  for(Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = transformation(mesh.point(v));
  return mesh;
}

constexpr int cells = 10;
constexpr double radius = 0.6; // three cells

Mesh wavy_graph()
{
  return make_graph(
    cells, [](double x, double y) { return 0.3 * std::sin(2 * x + y) * std::cos(3 * y) + 0.2 * x * x; }, 0.2);
}

} // namespace

class Every_estimator : public testing::TestWithParam<std::size_t>
{
protected:
  const Estimators all = all_estimators();
  const Estimator& estimator = *all[GetParam()];
};

INSTANTIATE_TEST_SUITE_P(All, Every_estimator, testing::Range(std::size_t(0), all_estimators().size()), name_of);

TEST_P(Every_estimator, HasANameOfItsOwnAndSettings)
{
  EXPECT_FALSE(estimator.settings().empty());
  for(const auto& other : all)
    EXPECT_EQ(other->name() == estimator.name(), other.get() == &estimator);
}

TEST_P(Every_estimator, BearsMeshesWithoutSurface)
{
  Mesh mesh;
  expect_well_formed(estimator, mesh, radius);
  mesh.add_vertex(Point(1, 2, 3));
  expect_well_formed(estimator, mesh, radius);
}

TEST_P(Every_estimator, BearsIsolatedVerticesAndLeavesThemNaN)
{
  Mesh mesh = wavy_graph();
  const std::vector<Estimate> before = estimates(estimator, mesh, radius);
  const Mesh::Vertex_index isolated = mesh.add_vertex(Point(0, 0, 0.01));
  expect_well_formed(estimator, mesh, radius);
  const std::vector<Estimate> after = estimates(estimator, mesh, radius);
  EXPECT_TRUE(std::isnan(after[isolated.idx()].max_curvature));
  EXPECT_TRUE(is_all_nan(after[isolated.idx()].normal));
  const std::size_t middle = middle_vertex(cells).idx();
  EXPECT_EQ(before[middle].max_curvature, after[middle].max_curvature);
}

TEST_P(Every_estimator, BearsASingleTriangle)
{
  Mesh mesh;
  const auto v = add_points(mesh, {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)});
  mesh.add_face(v[0], v[1], v[2]);
  expect_well_formed(estimator, mesh, radius);
}

TEST_P(Every_estimator, BearsFacesWithoutArea)
{
  Mesh line;
  const auto v = add_points(line, {Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(0, 0, 0)});
  line.add_face(v[0], v[1], v[2]);
  line.add_face(v[0], v[2], v[3]);
  expect_well_formed(estimator, line, radius);

  Mesh collapsed = wavy_graph(); // an edge, two edges, a whole star without length
  const Mesh::Vertex_index middle = middle_vertex(cells);
  for(Mesh::Vertex_index w : collapsed.vertices_around_target(collapsed.halfedge(middle)))
  {
    collapsed.point(w) = collapsed.point(middle);
    expect_well_formed(estimator, collapsed, radius);
  }
}

TEST_P(Every_estimator, BearsSliversAndFolds)
{
  Mesh mesh = wavy_graph();
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const Point p = mesh.point(v);
    mesh.point(v) = Point(p.x(), 1e-7 * p.y(), p.z());
  }
  expect_well_formed(estimator, mesh, radius);
  mesh = wavy_graph();
  mesh.point(middle_vertex(cells)) += Vector(0.7, 0.3, 0); // over its neighbours and beyond
  expect_well_formed(estimator, mesh, radius);
}

TEST_P(Every_estimator, BearsAnyRadius)
{
  const Mesh mesh = wavy_graph();
  for(double r : {1e-9, 0.05, 100.})
    expect_well_formed(estimator, mesh, r);
}

TEST_P(Every_estimator, GivesValuesInsideAPlainMesh)
{
  const Mesh mesh = wavy_graph();
  const std::vector<Estimate> out = estimates(estimator, mesh, radius);
  for(Mesh::Vertex_index v : inner_vertices(cells))
  {
    EXPECT_TRUE(std::isfinite(out[v.idx()].max_curvature));
    EXPECT_FALSE(is_all_nan(out[v.idx()].max_direction));
    EXPECT_GT(out[v.idx()].normal.z(), 0);
    EXPECT_NEAR(CGAL::cross_product(out[v.idx()].min_direction, out[v.idx()].max_direction).squared_length(), 1, 1e-9);
  }
}

TEST_P(Every_estimator, IsPositiveOnASphereFromOutsideAndNegativeFromInside)
{
  // measured: 0.112 for spider_published, whose fit must pass through the vertex, under which the facets sag: that error
  // is 0.34, 0.08 and 0.02 at one, two and four edges, here two, whatever the mesh; the others stay under 0.1
  const double tolerance = estimator.name() == "spider_published" ? 0.15 : 0.1;
  Mesh mesh = make_sphere(3);
  for(const Estimate& e : estimates(estimator, mesh, 0.3))
    EXPECT_NEAR(e.mean_curvature(), 1, tolerance);
  CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh);
  for(const Estimate& e : estimates(estimator, mesh, 0.3))
    EXPECT_NEAR(e.mean_curvature(), -1, tolerance);
}

// Moving, turning and scaling the mesh moves, turns and scales the answer. CGAL's corrected curvatures do so but
// nearly: they lift the normal's eigenvalue by a constant that has a unit (measured: 1.4e-3 off).
TEST_P(Every_estimator, IsEquivariant)
{
  const double tolerance = estimator.name().substr(0, 3) == "icc" ? 5e-3 : 1e-6;
  const Mesh mesh = wavy_graph();
  const double scale = 8;
  const double c = std::cos(0.7), s = std::sin(0.7);
  const CGAL::Aff_transformation_3<Kernel> turn(c, -s, 0, s, c, 0, 0, 0, 1), tilt(1, 0, 0, 0, c, -s, 0, s, c),
    stretch(CGAL::SCALING, scale), shift(CGAL::TRANSLATION, Vector(1, -2, 3));
  const auto rotation = turn * tilt;
  const std::vector<Estimate> before = estimates(estimator, mesh, radius);
  const std::vector<Estimate> after =
    estimates(estimator, transformed(mesh, shift * stretch * rotation), scale * radius);
  for(Mesh::Vertex_index v : inner_vertices(cells))
  {
    const Estimate &a = before[v.idx()], &b = after[v.idx()];
    EXPECT_NEAR(a.min_curvature, scale * b.min_curvature, tolerance);
    EXPECT_NEAR(a.max_curvature, scale * b.max_curvature, tolerance);
    EXPECT_NEAR(rotation(a.normal) * b.normal, 1, 1e-9);
    if(a.max_curvature - a.min_curvature > 0.1)
    {
      EXPECT_NEAR(line_angle(rotation(a.max_direction), b.max_direction), 0, tolerance);
    }
  }
}
