// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spider/Ridge_3.h>

#include "tracing.h"

#include <CGAL/Polygon_mesh_processing/locate.h>

#include <type_traits>

namespace {

using namespace tracing;

TEST(Ridge_3, starts_out_as_a_ridge_without_points)
{
  const Spider::Ridge_3<Mesh> line;
  EXPECT_TRUE(line.points.empty());
  EXPECT_TRUE(line.locations.empty());
  EXPECT_FALSE(line.is_closed);
  EXPECT_EQ(line.kind, Spider::ridge);
  EXPECT_EQ(line.strength, 0);
  EXPECT_EQ(line.sharpness, 0);
}

TEST(Ridge_3, is_of_the_callers_kernel_where_that_is_floating_point)
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  static_assert(std::is_same<Spider::Ridge_3<Mesh>::Point_3, Kernel::Point_3>::value, "");
  static_assert(std::is_same<Spider::Ridge_3<Epick_polyhedron>::Point_3, Epick::Point_3>::value, "");
  static_assert(std::is_same<Spider::Ridge_3<Epeck_mesh>::Point_3, Kernel::Point_3>::value, "");
  static_assert(std::is_same<Spider::Ridge_3<Epeck_mesh, Epick>::Point_3, Epick::Point_3>::value, "");
  static_assert(std::is_same<decltype(Spider::Ridge_3<Epeck_mesh>::strength), Kernel::FT>::value, "");
}

TEST(Ridge_3, has_locations_that_locate_takes)
{
  using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, Kernel::FT>;
  static_assert(std::is_same<Spider::Ridge_3<Mesh>::Face_location, Location>::value, "");
}

} // namespace
