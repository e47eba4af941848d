// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_SHARED_TANGENT_TENSOR_H
#define CGAL_SPIDER_BENCHMARK_SHARED_TANGENT_TENSOR_H

#include "vertex_normals.h"

namespace CGAL {
namespace Spider {
namespace benchmark {

// An orthonormal, right-handed frame around a unit normal.
struct Tangent_frame
{
  Vector u, v, normal;

  explicit Tangent_frame(const Vector& unit_normal) : normal(unit_normal)
  {
    // any axis that isn't near the normal will do; of the three, one is at least 54 degrees away
    const double x = std::abs(normal.x()), y = std::abs(normal.y()), z = std::abs(normal.z());
    const Vector axis = x <= y && x <= z ? Vector(1, 0, 0) : y <= z ? Vector(0, 1, 0) : Vector(0, 0, 1);
    u = normalized(CGAL::cross_product(axis, normal));
    v = CGAL::cross_product(normal, u);
  }
};

// A symmetric tensor of the tangent plane, by its components in a Tangent_frame.
struct Tangent_tensor
{
  double uu = 0, uv = 0, vv = 0;

  Tangent_tensor& operator+=(const Tangent_tensor& other)
  {
    uu += other.uu;
    uv += other.uv;
    vv += other.vv;
    return *this;
  }
  Tangent_tensor operator*(double s) const { return {s * uu, s * uv, s * vv}; }
};

// Sets the principal directions, where the greater curvature is at `angle` from u towards v.
inline void set_directions(Estimate& estimate, const Tangent_frame& frame, double angle)
{
  estimate.max_direction = std::cos(angle) * frame.u + std::sin(angle) * frame.v;
  estimate.min_direction = CGAL::cross_product(estimate.max_direction, frame.normal);
}

// What a curvature tensor (positive where the surface bends away from the normal) says in closed form. A tensor that
// isn't finite leaves all but the normal NaN.
inline Estimate principal_estimate(const Tangent_frame& frame, const Tangent_tensor& tensor)
{
  Estimate estimate;
  if(!is_finite(frame.normal))
    return estimate;
  estimate.normal = frame.normal;

  const double mean = (tensor.uu + tensor.vv) / 2, half_difference = (tensor.uu - tensor.vv) / 2;
  const double deviation = std::hypot(half_difference, tensor.uv);
  if(!std::isfinite(mean) || !std::isfinite(deviation))
    return estimate;
  estimate.min_curvature = mean - deviation;
  estimate.max_curvature = mean + deviation;
  set_directions(estimate, frame, std::atan2(tensor.uv, half_difference) / 2);
  return estimate;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_SHARED_TANGENT_TENSOR_H
