// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Spider/internal/elongation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace CGAL::Spider::internal;
using meshes::Vector;

namespace {

constexpr double rounding = 1e-15; // of some products of numbers around one

/// returns the share of the radius that a limb at an angle from the x axis reaches in the xy plane.
double share_at(double degrees, const Shortening<double>& shortening)
{
  const Spider_frame<double> frame(Vector(0, 0, 1), Vector(1, 0, 0));
  const double angle = degrees * meshes::pi / 180;
  return shares_reached(shortening, frame, Lanes<double>(std::cos(angle)), Lanes<double>(std::sin(angle)))[0];
}

} // namespace

TEST(elongation, limbs_reach_an_ellipse)
{
  const auto shortening = shortening_across(Vector(0, 3, 0));
  EXPECT_NEAR(share_at(90, shortening), 1, rounding);
  EXPECT_NEAR(share_at(270, shortening), 1, rounding);
  EXPECT_NEAR(share_at(0, shortening), 1 / 3., rounding);
  EXPECT_NEAR(share_at(45, shortening), 1 / std::sqrt(5), rounding); // x = y: x^2 + (3 x)^2 = 1, times 2 for x^2 + y^2
}

TEST(elongation, an_axis_may_point_anywhere)
{
  const double angle = 30 * meshes::pi / 180;
  const auto shortening = shortening_across(Vector(4 * std::cos(angle), 4 * std::sin(angle), 0));
  EXPECT_NEAR(share_at(30, shortening), 1, 4 * rounding); // of shares whose squares differ by sixteen times
  EXPECT_NEAR(share_at(120, shortening), 0.25, rounding);
  EXPECT_NEAR(share_at(-60, shortening), 0.25, rounding);
  EXPECT_LT(share_at(150, shortening), 0.3); // not the mirror image
}

TEST(elongation, an_axis_has_no_sign)
{
  EXPECT_EQ(shortening_across(Vector(1, -2, 0.5)), shortening_across(Vector(-1, 2, -0.5)));
}

TEST(elongation, a_tilted_axis_counts_by_its_tangential_part)
{
  const double tilt = 0.1;
  const auto shortening = shortening_across(Vector(2 * std::cos(tilt), 0, 2 * std::sin(tilt)));
  EXPECT_NEAR(share_at(0, shortening), 1 / std::sqrt(1 + 3 * std::pow(std::sin(tilt), 2)), rounding);
  EXPECT_NEAR(share_at(90, shortening), 0.5, rounding);
}

TEST(elongation, anything_but_a_vector_longer_than_one_is_a_disc)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const Vector& axis :
      {Vector(0, 0, 0), Vector(1, 0, 0), Vector(0.5, 0.5, 0.5), Vector(nan, 2, 0), Vector(infinity, 0, 0)})
    EXPECT_TRUE(shortening_across(axis).isZero(0)) << axis.transpose();
}

TEST(elongation, is_eight_at_most)
{
  EXPECT_NEAR(share_at(90, shortening_across(Vector(1e200, 0, 0))), 1 / 8., rounding);
  EXPECT_NEAR(share_at(0, shortening_across(Vector(1e200, 0, 0))), 1, rounding);
}
