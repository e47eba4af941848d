// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Results.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace CGAL::Spider::benchmark;

namespace {

Estimate estimate(double min_curvature, double max_curvature, double degrees = 0)
{
  Estimate e;
  e.min_curvature = min_curvature;
  e.max_curvature = max_curvature;
  const double angle = degrees * std::acos(-1) / 180;
  e.max_direction = Vector(std::cos(angle), std::sin(angle), 0);
  e.min_direction = Vector(std::sin(angle), -std::cos(angle), 0);
  e.normal = Vector(0, 0, 1);
  return e;
}

Errors compare_all(const std::vector<Estimate>& estimates, const std::vector<Estimate>& reference, double rms)
{
  std::vector<Mesh::Vertex_index> vertices;
  for(std::size_t i = 0; i < reference.size(); ++i)
    vertices.emplace_back(static_cast<Mesh::size_type>(i));
  return compare(estimates, reference, vertices, rms);
}

TEST(Summarise, TellsMeanMedianPercentileAndWorst)
{
  std::vector<double> numbers;
  for(int i = 100; i >= 0; --i)
    numbers.push_back(i);
  const Summary summary = summarise(numbers);
  EXPECT_DOUBLE_EQ(summary.mean, 50);
  EXPECT_DOUBLE_EQ(summary.median, 50);
  EXPECT_DOUBLE_EQ(summary.percentile_95, 95);
  EXPECT_DOUBLE_EQ(summary.worst, 100);
}

TEST(Compare, MeasuresInUnitsOfTheRmsCurvature)
{
  const Errors errors = compare_all({estimate(1, 5)}, {estimate(2, 3)}, 2);
  EXPECT_DOUBLE_EQ(errors.H.mean, 0.25);
  EXPECT_DOUBLE_EQ(errors.K.mean, 0.25);
  EXPECT_DOUBLE_EQ(errors.min_curvature.mean, 0.5);
  EXPECT_DOUBLE_EQ(errors.max_curvature.mean, 1);
  EXPECT_DOUBLE_EQ(errors.normal.mean, 0);
}

TEST(Compare, KnowsDirectionsFromTheirOpposites)
{
  EXPECT_NEAR(compare_all({estimate(0, 1, 190)}, {estimate(0, 1)}, 1).direction.mean, 10, 1e-12);
  EXPECT_NEAR(compare_all({estimate(0, 1, 100)}, {estimate(0, 1)}, 1).direction.mean, 80, 1e-12);
}

TEST(Compare, LeavesDirectionsAtUmbilicsOut)
{
  const Errors errors =
    compare_all({estimate(0.9, 1.1, 45), estimate(0, 1, 30)}, {estimate(1, 1.05), estimate(0, 1)}, 1);
  EXPECT_NEAR(errors.direction.worst, 30, 1e-12);
}

TEST(Compare, CountsTheWildAndTheMissing)
{
  const Errors errors =
    compare_all({estimate(0, 30), Estimate(), estimate(0, 1)}, {estimate(0, 1), estimate(0, 1), estimate(0, 1)}, 1);
  EXPECT_EQ(errors.vertices, 3u);
  EXPECT_EQ(errors.wild, 1u);
  EXPECT_EQ(errors.nan, 1u);
  EXPECT_DOUBLE_EQ(errors.H.worst, 14.5);
}

TEST(CompareByBorderDistance, SortsVerticesIntoBins)
{
  Recipe recipe;
  recipe.number_of_vertices = 900;
  const Surface surface = make_surface(recipe);
  std::vector<Estimate> estimates = surface.truth;
  for(auto v : surface.mesh.vertices()) // wrong by 1 at the border alone
    if(surface.mesh.is_border(v))
      estimates[v].max_curvature += 2 * surface.rms_curvature;
  const auto bins = compare_by_border_distance(estimates, surface, 4 * surface.mean_edge_length);
  ASSERT_EQ(bins.size(), border_bins.size());
  EXPECT_EQ(bins[0].vertices, 116u); // 4 sides of 29 edges
  EXPECT_NEAR(bins[0].H.mean, 1, 1e-12);
  EXPECT_DOUBLE_EQ(bins[2].H.worst, 0);

  recipe.shape = "sphere";
  const Surface closed = make_surface(recipe);
  EXPECT_TRUE(compare_by_border_distance(closed.truth, closed, 0.1).empty());
}

TEST(RobustRmsCurvature, IgnoresAHundredthOfWildValues)
{
  std::vector<Estimate> estimates(1000, estimate(-2, 2));
  for(std::size_t i = 0; i < 10; ++i)
    estimates[i] = estimate(-1e6, 1e6);
  EXPECT_NEAR(robust_rms_curvature(estimates), 2, 1e-12);
}

TEST(ToText, ShowsThreeDigits)
{
  EXPECT_EQ(to_text(123.4), "123");
  EXPECT_EQ(to_text(1.234), "1.23");
  EXPECT_EQ(to_text(0.1234), "0.123");
  EXPECT_EQ(to_text(1.234e-5), "1.2e-05");
  EXPECT_EQ(to_text(Estimate::nan), "-");
}

} // namespace
