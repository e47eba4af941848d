// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../noise.h"
#include "../smoothers.h"
#include "../surface_distance.h"
#include "../tessellations.h"
#include "test_meshes.h"

#include <gtest/gtest.h>

#include <set>

using namespace CGAL::Spider::benchmark;

namespace {

Mesh moved(Mesh mesh, const Vector& by)
{
  for(auto v : mesh.vertices())
    mesh.point(v) += by;
  return mesh;
}

TEST(SurfaceDistance, IsThatOfParallelPlanes)
{
  const Mesh plane = test::make_grid(8, [](double x, double y) { return Point(x, y, 0); });
  const Surface_distance none = surface_distance(plane, plane);
  EXPECT_LT(none.greatest, 1e-12);
  const Surface_distance above = surface_distance(plane, moved(plane, Vector(0, 0, 0.25)));
  EXPECT_NEAR(above.mean, 0.25, 1e-12);
  EXPECT_NEAR(above.greatest, 0.25, 1e-12);
}

// Half of a plane lies on the other; the other half is on average half, and at most all, of its width away.
TEST(SurfaceDistance, LooksBothWays)
{
  const Mesh plane = test::make_grid(16, [](double x, double y) { return Point(x, y, 0); });
  const Mesh half = test::make_grid(16, [](double x, double y) { return Point(x / 2, y, 0); });
  const Surface_distance distance = surface_distance(plane, half), back = surface_distance(half, plane);
  EXPECT_NEAR(distance.greatest, 0.5, 1e-12);
  EXPECT_NEAR(distance.mean, 0.125 / 2, 1e-12); // none there, an eighth on average back
  EXPECT_EQ(distance.greatest, back.greatest);
  EXPECT_NEAR(distance.mean, back.mean, 1e-12);
}

TEST(Smoothers, HaveNamesOfTheirOwnAndTakeNoiseOffASphere)
{
  const Mesh clean = test::make_sphere(3);
  Mesh noisy = clean;
  Random random(1);
  add_noise(noisy, area_weighted_normals(clean), mean_edge_length(clean), {1}, random);
  const double before = surface_distance(noisy, clean).mean;
  std::set<std::string> names;
  for(const Smoother& smoother : all_smoothers())
  {
    EXPECT_TRUE(names.insert(smoother.name).second) << smoother.name;
    double best = before;
    for(const double strength : smoother.strengths)
    {
      Mesh mesh = noisy;
      smoother.smooth(mesh, strength, 10);
      best = std::min(best, surface_distance(mesh, clean).mean);
    }
    if(smoother.name == "noisy")
    {
      EXPECT_EQ(best, before);
    }
    else if(smoother.name != "angle_and_area") // which evens triangles out, and is no remedy for noise
    {
      EXPECT_LT(best, 0.8 * before) << smoother.name;
    }
  }
}

} // namespace
