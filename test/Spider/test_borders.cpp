// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: near borders and holes estimates say what they rest on, and are finite and right wherever they are
// given.

#include "estimation.h"

#include <CGAL/Spider/estimate_curvature.h>

using namespace estimation;

namespace {

constexpr int directions = 64;
constexpr int n = 20; // the patches are squares of 2n by 2n cells around the origin

Vertex grid_vertex(int i, int j) { return Vertex(static_cast<Mesh::size_type>((2 * n + 1) * (i + n) + j + n)); }

/// returns the share of a full disc's directions' lengths that is left at a distance from a straight border, in radii.
double coverage_near_border(double distance)
{
  if(distance >= 1)
    return 1;
  const double a = std::acos(distance); // directions within this angle of the border's meet it
  const double lost = a - distance * std::log((1 + std::sin(a)) / std::cos(a));
  return 1 - lost / meshes::pi;
}

/// returns the share that is left beside a round hole. Lengths are in radii of the spider.
double coverage_beside_hole(double distance, double hole_radius)
{
  const double widest = std::asin(hole_radius / distance);
  constexpr int steps = 1000;
  double lost = 0;
  for(int i = 0; i < steps; ++i)
  {
    const double angle = widest * (2 * i + 1 - steps) / steps, beside = distance * std::sin(angle);
    const double reached = distance * std::cos(angle) - std::sqrt(hole_radius * hole_radius - beside * beside);
    lost += 2 * widest / steps * (1 - reached);
  }
  return 1 - lost / (2 * meshes::pi);
}

/// returns a mesh without the faces whose centroid is within a distance of a point.
Mesh punched(const Mesh& mesh, const Vector& centre, double hole_radius)
{
  Soup soup = soup_of(mesh);
  const auto is_in_hole = [&](const meshes::Triangle& t) {
    return ((soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]) / 3 - centre).norm() < hole_radius;
  };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), is_in_hole), soup.triangles.end());
  return meshes::from_soup<Mesh>(soup.points, soup.triangles);
}

double root_mean_square(const std::vector<double>& values)
{
  double sum = 0;
  for(double x : values)
    sum += x * x;
  return std::sqrt(sum / double(values.size()));
}

} // namespace

TEST(borders, half_a_spider_is_left_at_a_straight_border_and_a_quarter_in_a_corner)
{
  const Mesh plane = meshes::plane<Mesh>(n);
  for_each_setting(5.3, [&](const auto& settings) {
    const auto np = settings.number_of_directions(directions);
    const Estimate at_border = Spider::estimate_curvature(grid_vertex(-n, 0), plane, np);
    EXPECT_EQ(at_border.status, Spider::partial);
    EXPECT_NEAR(at_border.coverage, 0.5, 1.5 / (2 * directions)); // both limbs along the border may count, or neither
    EXPECT_NEAR(at_border.curvedness(), 0, 1e-12);
    const Estimate at_corner = Spider::estimate_curvature(grid_vertex(-n, -n), plane, np);
    EXPECT_NEAR(at_corner.coverage, 0.25, 1.5 / (2 * directions));
    expect_sound(at_corner);
    EXPECT_EQ(Spider::estimate_curvature(grid_vertex(0, 0), plane, np).status, Spider::ok);
  });
}

TEST(borders, coverage_is_the_share_of_the_limbs_that_the_border_leaves)
{
  const Mesh plane = meshes::plane<Mesh>(n);
  const double radius = 6.4;
  for_each_setting(radius, [&](const auto& settings) {
    const auto np = settings.number_of_directions(directions);
    for(int distance = 1; distance <= 8; ++distance)
    {
      const Estimate e = Spider::estimate_curvature(grid_vertex(n - distance, 0), plane, np);
      EXPECT_EQ(e.status, distance < radius ? Spider::partial : Spider::ok);
      EXPECT_NEAR(e.coverage, coverage_near_border(distance / radius), 0.01) << distance;
      EXPECT_NEAR(e.curvedness(), 0, 1e-12);
    }
  });
}

TEST(borders, a_hole_takes_its_share)
{
  const double radius = 5.3;
  const Mesh plane = meshes::plane<Mesh>(n);
  for_each_setting(radius, [&](const auto& settings) {
    const auto np = settings.number_of_directions(directions);
    EXPECT_NEAR(Spider::estimate_curvature(grid_vertex(3, 0), plane, np).coverage, 1, 1e-12);
  });
  const Mesh with_hole = punched(plane, Vector(0, 0, 0), 1.5);
  for_each_setting(radius, [&](const auto& settings) {
    const auto np = settings.number_of_directions(directions);
    const Estimate e = Spider::estimate_curvature(grid_vertex(3, 0), with_hole, np);
    EXPECT_EQ(e.status, Spider::partial);
    // The hole holds a disc of radius 1 and is held by one of radius 2.2.
    EXPECT_LE(e.coverage, coverage_beside_hole(3 / radius, 1 / radius));
    EXPECT_GE(e.coverage, coverage_beside_hole(3 / radius, 2.2 / radius));
    EXPECT_NEAR(e.curvedness(), 0, 1e-12);
    EXPECT_EQ(Spider::estimate_curvature(grid_vertex(8, 0), with_hole, np).status, Spider::ok);
  });
}

TEST(borders, a_hole_far_from_the_point_moves_values_by_less_than_noise_does)
{
  const double spacing = 0.05, edge = 1.14 * spacing; // the mean length in such a grid
  const double noise = 0.25 * edge, radius = 6 * edge;
  const Vertex centre = grid_vertex(0, 0);
  for_each_setting(radius, [&](const auto& np) {
    std::vector<double> errors, moves; // of the least curvature and of the greatest
    for(unsigned seed = 1; seed <= 20; ++seed)
    {
      const Mesh whole =
        meshes::jittered(meshes::saddle<Mesh>(n, spacing, 1, -1, meshes::alternating), noise / 2, seed);
      const Estimate before = Spider::estimate_curvature(centre, whole, np);
      EXPECT_EQ(before.status, Spider::ok);
      errors.insert(errors.end(), {before.min_curvature + 1, before.max_curvature - 1});
      constexpr int holes = 5; // one at a time, two edges wide, and for each seed in directions of its own
      for(int i = 0; i < holes; ++i)
      {
        const double angle = 2 * meshes::pi * (i + seed / 20.) / holes, distance = 2. / 3 * radius;
        const Vector hole = meshes::point(whole, centre) + distance * Vector(std::cos(angle), std::sin(angle), 0);
        const Estimate after = Spider::estimate_curvature(centre, punched(whole, hole, edge), np);
        EXPECT_EQ(after.status, Spider::partial);
        EXPECT_LT(after.coverage, before.coverage - 0.01);
        EXPECT_GT(after.coverage, before.coverage - 0.1);
        moves.insert(moves.end(),
                     {after.min_curvature - before.min_curvature, after.max_curvature - before.max_curvature});
      }
    }
    // Measured: 0.21 of the error as published, 0.26 by default.
    EXPECT_LE(root_mean_square(moves), 0.4 * root_mean_square(errors));
  });
}

TEST(borders, the_curvature_of_a_cylinder_is_found_up_to_its_rim)
{
  const int along = 20;
  const Mesh cylinder = meshes::cylinder<Mesh>(1, 2, 64, along);
  for_each_setting(0.5, [&](const auto& np) {
    for(int row = 0; row <= along; ++row)
    {
      const Estimate e = Spider::estimate_curvature(Vertex(static_cast<Mesh::size_type>(row)), cylinder, np);
      SCOPED_TRACE(row);
      expect_sound(e);
      ASSERT_TRUE(e.is_valid());
      const int to_rim = std::min(row, along - row); // in steps of 0.1: the fifth is at the radius
      if(to_rim != 5)
      {
        EXPECT_EQ(e.status, to_rim < 5 ? Spider::partial : Spider::ok);
      }
      // The paper's fit, which is pulled to the direction it is given, tilts where it sees one side alone. Measured for
      // it: curvature off by 0.44 on the rim, 0.22 next to it, 0.04 inside; the normal by 0.1, 0.054, 0.01.
      const double error = to_rim == 0 ? 0.55 : to_rim == 1 ? 0.28 : to_rim < 5 ? 0.2 : 0.06;
      EXPECT_NEAR(e.max_curvature, 1, error);
      EXPECT_NEAR(e.min_curvature, 0, error);
      EXPECT_LE(angle(vector(e.normal), Vector(1, 0, 0)), to_rim < 2 ? 0.125 : 0.03);
    }
  });
}

TEST(borders, every_vertex_of_a_noisy_patch_gets_a_sound_answer)
{
  const Mesh patch = meshes::jittered(meshes::saddle<Mesh>(8, 0.1, 1.5, -0.5, meshes::alternating), 0.03, 6);
  for_each_setting(0.6, [&](const auto& np) {
    int valid = 0;
    for(const Estimate& e : estimates(patch, np))
    {
      expect_sound(e);
      EXPECT_NE(e.status, Spider::isolated);
      EXPECT_TRUE(vector(e.normal).allFinite());
      EXPECT_GT(e.coverage, 0.1);
      valid += e.is_valid();
    }
    EXPECT_GE(valid, 289 - 4); // of 17 x 17, the corners aside
  });
}

TEST(borders, a_radius_beyond_the_mesh_is_partial)
{
  const Mesh patch = meshes::saddle<Mesh>(8, 0.1, 1.5, -0.5);
  for_each_setting(100., [&](const auto& np) {
    const Estimate e = Spider::estimate_curvature(Vertex(17 * 8 + 8), patch, np);
    expect_sound(e);
    EXPECT_NE(e.status, Spider::ok);
    EXPECT_LT(e.coverage, 0.02);
  });
}
