// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../estimators/Taubin_1995.h"
#include "test_meshes.h"

#include <gtest/gtest.h>

using namespace CGAL::Spider::benchmark;
using namespace CGAL::Spider::benchmark::test;

namespace {

// The star of a vertex at the origin: `count` neighbours at equal angles, at the distance `reach`, on the graph of
// z = a x^2 / 2 + b y^2 / 2.
Mesh make_star(int count, double reach, double a, double b)
{
  Mesh mesh;
  std::vector<Point> points{Point(0, 0, 0)};
  for(int i = 0; i < count; ++i)
  {
    const double t = 2 * CGAL_PI * i / count, x = reach * std::cos(t), y = reach * std::sin(t);
    points.emplace_back(x, y, (a * x * x + b * y * y) / 2);
  }
  const auto v = add_points(mesh, points);
  for(int i = 0; i < count; ++i)
    mesh.add_face(v[0], v[1 + i], v[1 + (i + 1) % count]);
  return mesh;
}

Estimate taubin_at_centre(const Mesh& mesh) { return estimates(Taubin_1995(), mesh)[0]; }

} // namespace

// Sphere, cylinder and saddle, seen from inside (z up): with edges at equal angles the sum is the paper's integral, and
// what is left is the chord's error, of second order.
TEST(Taubin_1995, ConvergesOnRegularStars)
{
  const double curvatures[][2] = {{1, 1}, {0, 1}, {-2, 0}, {1, -1}, {3, -0.5}};
  for(const auto& [a, b] : curvatures)
  {
    const auto error = [a = a, b = b](double reach) {
      const Estimate e = taubin_at_centre(make_star(8, reach, a, b));
      return std::abs(e.min_curvature - (std::min)(-a, -b)) + std::abs(e.max_curvature - (std::max)(-a, -b));
    };
    EXPECT_LT(error(0.01), 1e-3);
    EXPECT_NEAR(order(error(0.02), error(0.01)), 2, 0.05) << a << ' ' << b;
    if(a != b)
    {
      const Estimate e = taubin_at_centre(make_star(8, 0.01, a, b));
      EXPECT_NEAR(line_angle(e.max_direction, -a > -b ? Vector(1, 0, 0) : Vector(0, 1, 0)), 0, 1e-9);
      EXPECT_NEAR(e.normal.z(), 1, 1e-12);
    }
  }
}

// 2 n.(x_j - x_i) / |x_j - x_i|^2 is exact for chords of a sphere, so that only the normal and the edges' spacing err.
TEST(Taubin_1995, IsNearTheTruthOnASphere)
{
  const double radius = 2;
  const Mesh mesh = make_sphere(4, radius);
  const std::vector<Estimate> all = estimates(Taubin_1995(), mesh);
  EXPECT_LT(mean_error(all, mesh.vertices(), 1 / radius, mean), 1e-4);  // measured: 3.9e-5
  EXPECT_LT(worst_error(all, mesh.vertices(), 1 / radius, mean), 2e-3); // measured: 6.7e-4
}

// Four equal faces, bent along y alone: all weights are 1/4, M = diag(0, k/2), and its eigenvalues give 3k/2 and -k/2.
TEST(Taubin_1995, IsAsComputedByHandOnACross)
{
  const double width = 2, height = 1, bend = 0.01;
  Mesh mesh;
  const auto v = add_points(
    mesh, {Point(0, 0, 0), Point(width, 0, 0), Point(0, height, -bend), Point(-width, 0, 0), Point(0, -height, -bend)});
  for(int i = 0; i < 4; ++i)
    mesh.add_face(v[0], v[1 + i], v[1 + (i + 1) % 4]);
  const Estimate e = taubin_at_centre(mesh);
  const double k = 2 * bend / (height * height + bend * bend);
  EXPECT_NEAR(e.max_curvature, 1.5 * k, 1e-12);
  EXPECT_NEAR(e.min_curvature, -0.5 * k, 1e-12);
}

// The right half of that cross: the edge to the right has both faces' areas, those up and down one each.
TEST(Taubin_1995, WeighsEdgesByTheAreaOfTheirFaces)
{
  const double width = 2, height = 1, bend = 0.01;
  Mesh mesh;
  const auto v =
    add_points(mesh, {Point(0, 0, 0), Point(width, 0, 0), Point(0, height, -bend), Point(0, -height, -bend)});
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[0], v[3], v[1]);
  const Estimate e = taubin_at_centre(mesh);
  const double along_x = -2 * e.normal.x() / width, along_y = 2 * e.normal.z() * bend / (height * height + bend * bend);
  EXPECT_NEAR(e.normal.y(), 0, 1e-15);
  EXPECT_NEAR(e.mean_curvature(), (2 * along_x + along_y + along_y) / 4, 1e-12); // the trace of M
}
