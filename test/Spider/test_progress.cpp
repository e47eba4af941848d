// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Long work tells a visitor how far it is, and lets itself be cancelled.

#include "estimation.h"

#include <CGAL/Spider/estimate_curvatures.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/estimate_vertex_normals.h>

#include <functional>
#include <iterator>
#include <map>
#include <vector>

using namespace estimation;

namespace {

struct Cancelled
{
};

struct Visitor
{
  std::vector<double>* shares; // a visitor is copied
  double cancel_at = 2;

  void progress(double share)
  {
    shares->push_back(share);
    if(share >= cancel_at)
      throw Cancelled();
  }
};

void expect_from_0_to_1(const std::vector<double>& shares)
{
  ASSERT_GE(shares.size(), 2u);
  EXPECT_GT(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
  for(std::size_t i = 1; i < shares.size(); ++i)
    EXPECT_GT(shares[i], shares[i - 1]);
}

Mesh large_mesh() { return meshes::icosphere<Mesh>(5); } // 10,242 vertices: more than are worked on at once

} // namespace

TEST(progress, is_told_by_all_functions_over_many_points)
{
  const Mesh mesh = large_mesh();
  const auto radius = params::geodesic_radius(0.05);
  std::vector<double> shares;
  std::map<Vertex, Estimate> curvatures;
  Spider::estimate_vertex_curvatures(mesh, boost::make_assoc_property_map(curvatures), radius.visitor(Visitor{&shares}));
  expect_from_0_to_1(shares);

  shares.clear();
  std::vector<Estimate> estimates;
  Spider::estimate_curvatures(vertices(mesh), mesh, std::back_inserter(estimates), radius.visitor(Visitor{&shares}));
  expect_from_0_to_1(shares);

  shares.clear();
  std::map<Vertex, Kernel::Vector_3> normals;
  Visitor visitor{&shares};
  Spider::estimate_vertex_normals(mesh, boost::make_assoc_property_map(normals), radius.visitor(std::ref(visitor)));
  expect_from_0_to_1(shares);
}

TEST(progress, what_a_visitor_throws_cancels_and_keeps_what_is_done)
{
  const Mesh mesh = large_mesh();
  std::vector<double> shares;
  std::vector<Estimate> estimates;
  EXPECT_THROW(Spider::estimate_curvatures<CGAL::Parallel_if_available_tag>(
                 vertices(mesh), mesh, std::back_inserter(estimates),
                 params::geodesic_radius(0.05).visitor(Visitor{&shares, 0.1})),
               Cancelled);
  ASSERT_EQ(shares.size(), 1u);
  EXPECT_EQ(estimates.size(), std::size_t(std::lround(shares[0] * mesh.number_of_vertices())));
  for(const Estimate& e : estimates)
    EXPECT_EQ(e.status, Spider::ok);
}
