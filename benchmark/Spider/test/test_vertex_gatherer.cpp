// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../estimators/shared/Vertex_gatherer.h"
#include "test_meshes.h"

#include <gtest/gtest.h>

#include <set>

using namespace CGAL::Spider::benchmark;
using namespace CGAL::Spider::benchmark::test;

namespace {

constexpr int cells = 10;

Mesh flat_grid()
{
  return make_graph(cells, [](double, double) { return 0.; });
}

} // namespace

// The grid's triangles have their diagonals all one way, so that inner vertices have valence six.
TEST(Vertex_gatherer, GathersTheFewestWholeRings)
{
  const Mesh mesh = flat_grid();
  Vertex_gatherer gatherer(mesh);
  const Mesh::Vertex_index v = middle_vertex(cells);
  EXPECT_EQ(gatherer.rings(v, 1).size(), 1u);
  EXPECT_EQ(gatherer.rings(v, 2).size(), 7u);
  EXPECT_EQ(gatherer.rings(v, 7).size(), 7u);
  EXPECT_EQ(gatherer.rings(v, 8).size(), 19u);
  EXPECT_EQ(gatherer.rings(v, 20).size(), 37u);
  EXPECT_EQ(gatherer.rings(v, 1000).size(), mesh.num_vertices());
  EXPECT_EQ(gatherer.rings(Mesh::Vertex_index(0), 2).size(), 4u); // a corner
}

TEST(Vertex_gatherer, GathersEachVertexOnceAndTheCentreFirst)
{
  const Mesh mesh = flat_grid();
  Vertex_gatherer gatherer(mesh);
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const auto& gathered = gatherer.ball(v, 0.65, 1);
    EXPECT_EQ(gathered.front(), v);
    EXPECT_EQ(std::set<Mesh::Vertex_index>(gathered.begin(), gathered.end()).size(), gathered.size());
  }
}

TEST(Vertex_gatherer, GathersAllOfABall)
{
  const Mesh mesh = flat_grid();
  Vertex_gatherer gatherer(mesh);
  const Mesh::Vertex_index v = middle_vertex(cells);
  const double cell = 2. / cells;
  EXPECT_EQ(gatherer.ball(v, 1.01 * cell, 1).size(), 5u); // lattice points in a circle
  EXPECT_EQ(gatherer.ball(v, 1.42 * cell, 1).size(), 9u);
  EXPECT_EQ(gatherer.ball(v, 2.01 * cell, 1).size(), 13u);
  EXPECT_EQ(gatherer.ball(v, 2.24 * cell, 1).size(), 21u);
}

TEST(Vertex_gatherer, GrowsTheBallToTheNumberAskedFor)
{
  const Mesh mesh = flat_grid();
  Vertex_gatherer gatherer(mesh);
  const Mesh::Vertex_index v = middle_vertex(cells);
  EXPECT_EQ(gatherer.ball(v, 0, 2).size(), 5u); // the next distance, and all that have it
  EXPECT_GE(gatherer.ball(v, 0.01, 15).size(), 15u);
  EXPECT_LE(gatherer.ball(v, 0.01, 15).size(), 30u);
  EXPECT_EQ(gatherer.ball(v, 0.01, 1000).size(), mesh.num_vertices());
}

TEST(Vertex_gatherer, StaysOnTheSheetOfItsCentre)
{
  Mesh mesh = flat_grid();
  const std::size_t sheet = mesh.num_vertices();
  mesh.join(make_graph(cells, [](double, double) { return 0.01; }));
  const Mesh::Vertex_index isolated = mesh.add_vertex(Point(0, 0, 0));
  Vertex_gatherer gatherer(mesh);
  for(Mesh::Vertex_index v : gatherer.ball(middle_vertex(cells), 10, 1))
    EXPECT_LT(v.idx(), sheet);
  EXPECT_EQ(gatherer.ball(middle_vertex(cells), 10, 1).size(), sheet);
  EXPECT_EQ(gatherer.ball(isolated, 10, 5).size(), 1u);
  EXPECT_EQ(gatherer.rings(isolated, 5).size(), 1u);
}
