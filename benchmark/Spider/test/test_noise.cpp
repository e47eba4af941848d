// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Surface.h"

#include <gtest/gtest.h>

using namespace CGAL::Spider::benchmark;

namespace {

// how far each vertex was moved along its normal, in mean edge lengths
std::vector<double> displacements(const Noise& noise)
{
  Recipe recipe;
  recipe.number_of_vertices = 40000;
  const Surface clean = make_surface(recipe);
  recipe.noise = noise;
  const Surface noisy = make_surface(recipe);
  std::vector<double> result;
  for(auto v : clean.mesh.vertices())
  {
    const Vector moved = noisy.mesh.point(v) - clean.mesh.point(v);
    const Vector& normal = clean.truth[v].normal;
    EXPECT_NEAR(CGAL::cross_product(moved, normal).squared_length(), 0, 1e-24);
    result.push_back(moved * normal / clean.mean_edge_length);
  }
  return result;
}

double mean_square(const std::vector<double>& numbers)
{
  double sum = 0;
  for(double number : numbers)
    sum += number * number / static_cast<double>(numbers.size());
  return sum;
}

TEST(Random, IsWhatTheStandardSaysItIs)
{
  std::mt19937_64 engine(5489);
  engine.discard(9999);
  EXPECT_EQ(engine(), 9981545732273789042u); // [rand.predef]
  Random random(5489);
  EXPECT_DOUBLE_EQ(random.uniform(), static_cast<double>(14514284786278117030u >> 11) * 0x1p-53);
}

TEST(Noise, UniformStaysWithinHalfItsAmplitude)
{
  Noise noise;
  noise.amplitude = 0.5;
  const auto moved = displacements(noise);
  for(double distance : moved)
    EXPECT_LE(std::abs(distance), 0.25 + 1e-12);
  // the relative standard error of the mean square of 40,000 numbers is 0.4 %
  EXPECT_NEAR(mean_square(moved), 0.25 / 12, 0.02 * 0.25 / 12);
}

TEST(Noise, GaussianHasTheStandardDeviationOfUniform)
{
  Noise noise;
  noise.amplitude = 0.5;
  noise.distribution = Noise::Distribution::gaussian;
  const auto moved = displacements(noise);
  // 0.7 % standard error
  EXPECT_NEAR(mean_square(moved), 0.25 / 12, 0.03 * 0.25 / 12);
  EXPECT_GT(*std::max_element(moved.begin(), moved.end()), 0.4);
}

TEST(Noise, MovesOutliersByThreeEdges)
{
  Noise noise;
  noise.outlier_share = 0.01;
  std::size_t up = 0, down = 0;
  for(double distance : displacements(noise))
  {
    up += distance > 2.999;
    down += distance < -2.999;
    EXPECT_TRUE(std::abs(distance) < 1e-9 || std::abs(std::abs(distance) - 3) < 1e-9);
  }
  // 200 each are expected; four standard deviations are 57
  EXPECT_NEAR(static_cast<double>(up), 200, 57);
  EXPECT_NEAR(static_cast<double>(down), 200, 57);
}

} // namespace
