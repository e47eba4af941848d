// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spider/resample.h>
#include <CGAL/Spider/trace_limb.h>

#include "tracing.h"

namespace {

using namespace tracing;
using Spider::resample;
using Spider::parameters::geodesic_radius;

using Limb = Spider::Limb_3<Mesh>;

/// returns a limb through the given points.
Limb limb_through(const Polyline& points)
{
  Limb limb;
  for(const Vector& p : points)
    limb.polyline.emplace_back(p.x(), p.y(), p.z());
  limb.length = length(points);
  return limb;
}

/// returns the point of a polyline at an arc length.
Vector at_length(const Polyline& points, double at)
{
  for(std::size_t i = 1; i < points.size(); ++i)
  {
    const double step = (points[i] - points[i - 1]).norm();
    if(at <= step)
      return points[i - 1] + at / step * (points[i] - points[i - 1]);
    at -= step;
  }
  return points.back();
}

TEST(Resample, gives_points_at_regular_arc_length_and_both_ends)
{
  const Limb limb = limb_through({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 2, 0.1}, {1, 2, 0.2}, {3, 2, 0.2}});
  for(double step : {0.07, 0.3, 0.9, 2.5})
  {
    const Polyline points = polyline(resample(limb, step));
    ASSERT_EQ(points.size(), std::size_t(limb.length / step) + 2);
    for(std::size_t i = 0; i + 1 < points.size(); ++i)
      EXPECT_LE((points[i] - at_length(polyline(limb.polyline), double(i) * step)).norm(), 1e-14);
    EXPECT_EQ(points.back(), Vector(3, 2, 0.2));
  }
}

TEST(Resample, does_not_double_the_end_of_a_limb_that_is_a_multiple_of_the_step)
{
  const Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(3), 0.02, 1);
  int number = 0;
  for(auto v : vertices(mesh))
  {
    if(number++ % 10 != 0)
      continue;
    const auto limb = Spider::trace_limb(v, kernel_vector(vertex_normal(mesh, v)), Kernel::Vector_3(1, 2, 3), mesh,
                                         geodesic_radius(0.7));
    const auto points = resample(limb, 0.1 * 0.7);
    ASSERT_EQ(points.size(), 11u);
    EXPECT_EQ(points.front(), limb.polyline.front());
    EXPECT_LE((meshes::vector(points.back()) - meshes::vector(limb.polyline.back())).norm(), 1e-14);
  }
}

TEST(Resample, does_not_double_the_end_where_multiples_of_the_step_miss_it_by_rounding)
{
  const Limb limb = limb_through({{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}});
  ASSERT_LT(49 * (1. / 49), 1);
  EXPECT_EQ(resample(limb, 1. / 49).size(), 50u);
  ASSERT_GT(3 * 0.1, 0.3);
  EXPECT_EQ(resample(limb_through({{0, 0, 0}, {0.3, 0, 0}}), 0.1).size(), 4u);
}

TEST(Resample, gives_both_ends_of_a_limb_shorter_than_a_step)
{
  const Limb limb = limb_through({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  const std::vector<Kernel::Point_3> ends = {limb.polyline.front(), limb.polyline.back()};
  EXPECT_EQ(resample(limb, 2.5), ends);
  EXPECT_EQ(resample(limb, 1e300), ends);
}

TEST(Resample, gives_the_one_point_of_a_limb_that_has_no_other)
{
  const Limb limb = limb_through({{1, 2, 3}});
  EXPECT_EQ(resample(limb, 0.1), limb.polyline);
}

TEST(Resample, passes_over_segments_without_length)
{
  const Limb limb = limb_through({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 0}});
  const std::vector<Kernel::Point_3> expected = {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1.5, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(resample(limb, 0.5), expected);
}

TEST(Resample, refuses_a_step_that_is_no_positive_length_or_gives_too_many_points)
{
  const Limb limb = limb_through({{0, 0, 0}, {1, 0, 0}});
  expect_refused([&] { resample(limb, 0.); }, {"step is 0", "positive"});
  expect_refused([&] { resample(limb, -0.5); }, {"step is -0.5", "positive"});
  expect_refused([&] { resample(limb, std::nan("")); }, {"step is", "nan"});
  expect_refused([&] { resample(limb, std::numeric_limits<double>::infinity()); }, {"step is inf"});
  expect_refused([&] { resample(limb, 1e-9); }, {"step is 1e-09", "ten million"});
}

} // namespace
