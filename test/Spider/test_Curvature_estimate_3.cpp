// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"

#include <sstream>

using namespace estimation;

namespace {

Estimate with_curvatures(double min, double max)
{
  Estimate e;
  e.min_curvature = min;
  e.max_curvature = max;
  return e;
}

} // namespace

TEST(Curvature_estimate_3, is_nan_and_says_why_until_it_is_made)
{
  const Estimate e;
  EXPECT_EQ(e.status, Spider::isolated);
  EXPECT_FALSE(e.is_valid());
  EXPECT_EQ(e.coverage, 0);
  EXPECT_TRUE(std::isnan(e.mean_curvature()) && std::isnan(e.Gaussian_curvature()) && std::isnan(e.curvedness()) &&
              std::isnan(e.shape_index()) && std::isnan(e.residual));
  EXPECT_TRUE(vector(e.normal).array().isNaN().all());
  expect_sound(e);
}

TEST(Curvature_estimate_3, derives_curvatures)
{
  const Estimate e = with_curvatures(-1, 7);
  EXPECT_EQ(e.mean_curvature(), 3);
  EXPECT_EQ(e.Gaussian_curvature(), -7);
  EXPECT_DOUBLE_EQ(e.curvedness(), 5);
}

TEST(Curvature_estimate_3, shape_index_tells_shapes_apart)
{
  EXPECT_DOUBLE_EQ(with_curvatures(2, 2).shape_index(), 1);
  EXPECT_DOUBLE_EQ(with_curvatures(0, 2).shape_index(), 0.5);
  EXPECT_DOUBLE_EQ(with_curvatures(-2, 2).shape_index(), 0);
  EXPECT_DOUBLE_EQ(with_curvatures(-2, 0).shape_index(), -0.5);
  EXPECT_DOUBLE_EQ(with_curvatures(-2, -2).shape_index(), -1);
  EXPECT_TRUE(std::isnan(with_curvatures(0, 0).shape_index()));
}

TEST(Curvature_estimate_3, is_valid_if_there_are_values)
{
  Estimate e;
  for(const auto& [status, valid, name] :
      {std::make_tuple(Spider::ok, true, "ok"), std::make_tuple(Spider::partial, true, "partial"),
       std::make_tuple(Spider::insufficient, false, "insufficient"),
       std::make_tuple(Spider::isolated, false, "isolated")})
  {
    e.status = status;
    EXPECT_EQ(e.is_valid(), valid);
    std::ostringstream out;
    out << status;
    EXPECT_EQ(out.str(), name);
  }
}

TEST(Curvature_estimate_3, converts_to_another_kernel)
{
  Estimate e = with_curvatures(-0.5, 1.5);
  e.min_direction = Kernel::Vector_3(1, 0, 0);
  e.max_direction = Kernel::Vector_3(0, 1, 0);
  e.normal = Kernel::Vector_3(0, 0, 1);
  e.status = Spider::partial;
  e.coverage = 0.75;
  e.residual = 0.125;

  using Narrow = Spider::Curvature_estimate_3<CGAL::Simple_cartesian<float>>;
  const Narrow narrow(e);
  EXPECT_EQ(narrow.min_curvature, -0.5f);
  EXPECT_EQ(narrow.max_curvature, 1.5f);
  EXPECT_EQ(narrow.min_direction, Narrow::Vector_3(1, 0, 0));
  expect_identical(Estimate(narrow), e); // all of these are floats, so nothing is lost
}
