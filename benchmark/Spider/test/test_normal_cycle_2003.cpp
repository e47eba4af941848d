// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../estimators/Normal_cycle_2003.h"
#include "test_meshes.h"

#include <gtest/gtest.h>

using namespace CGAL::Spider::benchmark;
using namespace CGAL::Spider::benchmark::test;

namespace {

// The area in a ball around the origin of a triangle of the plane z = height.
double clipped_area(const Point& a, const Point& b, const Point& c, double radius)
{
  const std::array<Vector, 3> corners{a - Point(0, 0, 0), b - Point(0, 0, 0), c - Point(0, 0, 0)};
  const Vector doubled = CGAL::cross_product(b - a, c - a);
  const double length = std::sqrt(doubled.squared_length());
  return area_in_ball(corners, doubled / length, length / 2, radius * radius);
}

// Two half planes that meet in the y axis, and both fall away from it by half of the angle.
Mesh make_ridge(int cells, double angle)
{
  return make_grid(cells, [&](double s, double t) {
    const double x = 2 * s - 1;
    return Point(x * std::cos(angle / 2), 2 * t - 1, -std::abs(x) * std::sin(angle / 2));
  });
}

} // namespace

TEST(Area_in_ball, IsTheTrianglesWhereTheBallHoldsIt)
{
  EXPECT_DOUBLE_EQ(clipped_area(Point(0, 0, 0.1), Point(1, 0, 0.1), Point(0, 1, 0.1), 2), 0.5);
}

TEST(Area_in_ball, IsTheDiscsWhereTheTriangleHoldsIt)
{
  const Point a(-9, -9, 0.6), b(9, -9, 0.6), c(0, 9, 0.6);
  EXPECT_NEAR(clipped_area(a, b, c, 1), CGAL_PI * 0.64, 1e-13); // the disc's radius is 0.8
  EXPECT_NEAR(clipped_area(a, c, b, 1), CGAL_PI * 0.64, 1e-13);
  EXPECT_EQ(clipped_area(a, b, c, 0.5), 0);
}

TEST(Area_in_ball, IsASegmentsOrASectors)
{
  const double r = 1, distance = 0.5; // of a side from the centre
  const double segment = r * r * std::acos(distance / r) - distance * std::sqrt(r * r - distance * distance);
  EXPECT_NEAR(clipped_area(Point(distance, -9, 0), Point(9, 0, 0), Point(distance, 9, 0), r), segment, 1e-13);
  EXPECT_NEAR(clipped_area(Point(0, 0, 0), Point(9, 0, 0), Point(0, 9, 0), r), CGAL_PI / 4, 1e-13);
  EXPECT_NEAR(clipped_area(Point(2, 2, 0), Point(9, 0, 0), Point(0, 9, 0), r), 0, 1e-13);
}

// However a triangle is cut, the parts' areas add up.
TEST(Area_in_ball, IsAdditive)
{
  std::mt19937 random(5);
  const auto point = [&] {
    const double x = double(random()) / double(std::mt19937::max()), y = double(random()) / double(std::mt19937::max());
    return Point(4 * x - 2, 4 * y - 2, 0.3 * x + 0.2);
  };
  for(int trial = 0; trial < 200; ++trial)
  {
    const Point a = point(), b = point(), c = point(), on_side = CGAL::barycenter(a, 0.3, b, 0.7);
    EXPECT_NEAR(clipped_area(a, b, c, 1), clipped_area(a, on_side, c, 1) + clipped_area(on_side, b, c, 1), 1e-12);
  }
}

// Along a straight edge of angle beta the ball holds 2 r of it and pi r^2 of area: k = 2 beta / (pi r) across.
TEST(Normal_cycle_2003, IsAsComputedByHandOnARidge)
{
  const int cells = 20;
  const double radius = 0.45;
  for(double beta : {CGAL_PI / 2, 0.3, -0.3}) // a cube's edge, an obtuse one, a valley
  {
    const Mesh mesh = make_ridge(cells, beta);
    const Estimate e = estimates(Normal_cycle_2003(), mesh, radius)[middle_vertex(cells).idx()];
    const double curvature = 2 * beta / (CGAL_PI * radius);
    EXPECT_NEAR(e.max_curvature, (std::max)(0., curvature), 1e-12);
    EXPECT_NEAR(e.min_curvature, (std::min)(0., curvature), 1e-12);
    const Vector across = beta > 0 ? e.max_direction : e.min_direction;
    EXPECT_NEAR(line_angle(across, Vector(1, 0, 0)), 0, 1e-12);
    EXPECT_NEAR(e.normal.z(), 1, 1e-12);
  }
}

// Cohen-Steiner and Morvan's bound wants edges small against the ball: at a fixed radius the measure of a sphere's mesh
// goes to the sphere's, whose mean curvature over any ball is 1/R.
TEST(Normal_cycle_2003, ConvergesOnASphereAtAFixedRadius)
{
  const double sphere_radius = 2, H = 1 / sphere_radius, ball = 1;
  const auto error = [&](unsigned int subdivisions) {
    const Mesh mesh = make_sphere(subdivisions, sphere_radius);
    return mean_error(estimates(Normal_cycle_2003(), mesh, ball), mesh.vertices(), H, mean) / H;
  };
  EXPECT_LT(error(4), error(2) / 4); // two halvings, first order at least; measured: 1/23
  EXPECT_LT(error(4), 0.01);         // measured: 0.0029
}

TEST(Normal_cycle_2003, ConvergesOnACylinderAtAFixedRadius)
{
  const double ball = 0.35;
  const auto error = [&](int cells) {
    const auto all = estimates(Normal_cycle_2003(), make_cylinder(cells), ball);
    EXPECT_LT(worst_error(all, inner_vertices(cells), 0, least), 1e-12); // all edges that bend lie along the axis
    return worst_error(all, inner_vertices(cells), 1, greatest);
  };
  const double fine = error(80);
  EXPECT_LT(fine, error(20) / 3); // measured: 1/3.5, from 0.0125
  EXPECT_LT(fine, 5e-3);
}

TEST(Normal_cycle_2003, StaysOnItsOwnSheet)
{
  const int cells = 20;
  Mesh mesh = make_ridge(cells, 0.5);
  const Estimate alone = estimates(Normal_cycle_2003(), mesh, 0.4)[middle_vertex(cells).idx()];
  mesh.join(make_graph(cells, [](double x, double y) { return 0.05 + x * x + y * y; }));
  const Estimate beside = estimates(Normal_cycle_2003(), mesh, 0.4)[middle_vertex(cells).idx()];
  EXPECT_EQ(alone.max_curvature, beside.max_curvature);
  EXPECT_EQ(alone.min_curvature, beside.min_curvature);
}
