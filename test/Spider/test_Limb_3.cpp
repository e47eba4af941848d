// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spider/Limb_3.h>

#include "tracing.h"

#include <sstream>
#include <type_traits>

namespace {

using namespace tracing;

TEST(Limb_3, starts_out_as_one_that_leads_nowhere)
{
  const Spider::Limb_3<Mesh> limb;
  EXPECT_TRUE(limb.polyline.empty());
  EXPECT_EQ(limb.length, 0);
  EXPECT_EQ(limb.end, Spider::degenerate);
  EXPECT_EQ(limb.edge, boost::graph_traits<Mesh>::edge_descriptor());
}

TEST(Limb_3, is_of_the_callers_kernel_where_that_is_floating_point)
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  using Long = CGAL::Simple_cartesian<long double>;
  static_assert(std::is_same<Spider::Limb_3<Mesh>::Point_3, Kernel::Point_3>::value, "");
  static_assert(std::is_same<Spider::Limb_3<Epick_polyhedron>::Point_3, Epick::Point_3>::value, "");
  static_assert(std::is_same<Spider::Limb_3<Epeck_mesh>::Point_3, Kernel::Point_3>::value, "");
  static_assert(std::is_same<Spider::Limb_3<CGAL::Surface_mesh<Long::Point_3>>::FT, long double>::value, "");
  static_assert(std::is_same<Spider::Limb_3<Epeck_mesh, Epick>::Point_3, Epick::Point_3>::value, "");
  static_assert(!std::is_same<Spider::Limb_3<Epeck_mesh>::Point_3, Epeck::Point_3>::value, "");
}

TEST(Limb_3, tells_how_it_ended)
{
  const auto name = [](Spider::Limb_end end) {
    std::ostringstream out;
    out << end;
    return out.str();
  };
  EXPECT_EQ(name(Spider::radius_reached), "radius_reached");
  EXPECT_EQ(name(Spider::border), "border");
  EXPECT_EQ(name(Spider::feature_edge), "feature_edge");
  EXPECT_EQ(name(Spider::slowed), "slowed");
  EXPECT_EQ(name(Spider::degenerate), "degenerate");
}

} // namespace
