// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_SHARED_BALL_CLIPPING_H
#define CGAL_SPIDER_BENCHMARK_SHARED_BALL_CLIPPING_H

#include "Face_geometry.h"

#include <algorithm>

namespace CGAL {
namespace Spider {
namespace benchmark {

// The part of the line a + t (b - a) in the ball of squared radius `squared_radius` around `centre`: [first, second],
// clipped to [0, 1]; first == second where the segment misses the ball.
struct Clipped_segment
{
  double first = 0, second = 0;

  Clipped_segment(const Vector& from_centre_to_a, const Vector& side, double squared_radius)
  {
    // |a + t side|^2 = squared_radius; `side` is no null vector
    const double squared_length = side.squared_length(), middle = -(from_centre_to_a * side) / squared_length;
    const double discriminant = middle * middle - (from_centre_to_a.squared_length() - squared_radius) / squared_length;
    if(!(discriminant > 0))
      return;
    const double half = std::sqrt(discriminant);
    first = (std::min)(1., (std::max)(0., middle - half));
    second = (std::min)(1., (std::max)(0., middle + half));
  }

  double share() const { return second - first; }
  bool is_empty() const { return !(second > first); }
};

namespace internal {

// Twice the signed area of the part, within the disc around the origin, of the triangle (origin, a, a + side).
// All vectors lie in one plane, whose unit normal says which turn is positive.
inline double doubled_disc_area(const Vector& a, const Vector& side, const Vector& unit_normal, double squared_radius)
{
  const auto cross = [&](const Vector& p, const Vector& q) { return CGAL::cross_product(p, q) * unit_normal; };
  const auto sector = [&](const Vector& p, const Vector& q) { return squared_radius * std::atan2(cross(p, q), p * q); };
  const Vector b = a + side;
  const Clipped_segment inside(a, side, squared_radius);
  if(inside.is_empty())
    return sector(a, b);
  const Vector p = a + inside.first * side, q = a + inside.second * side;
  double area = cross(p, q);
  if(inside.first > 0)
    area += sector(a, p);
  if(inside.second < 1)
    area += sector(q, b);
  return area;
}

} // namespace internal

// The area of the part of a face within the ball; exact. `corners` lead from the ball's centre to the face's corners.
inline double area_in_ball(const std::array<Vector, 3>& corners, const Vector& unit_normal, double area,
                           double squared_radius)
{
  if(std::all_of(corners.begin(), corners.end(), [&](const Vector& c) { return c.squared_length() <= squared_radius; }))
    return area;
  // the plane cuts a disc out of the ball
  const Vector offset = (corners[0] * unit_normal) * unit_normal;
  const double squared_disc_radius = squared_radius - offset.squared_length();
  if(!(squared_disc_radius > 0))
    return 0;
  double doubled_area = 0;
  for(int i = 0; i < 3; ++i)
    doubled_area += internal::doubled_disc_area(corners[i] - offset, corners[next_corner(i)] - corners[i], unit_normal,
                                                squared_disc_radius);
  return (std::max)(0., doubled_area / 2);
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_SHARED_BALL_CLIPPING_H
