// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_LOCAL_COORDINATES_H
#define CGAL_SPIDER_INTERNAL_LOCAL_COORDINATES_H

#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/numbers.h>

#include <limits>

namespace CGAL {
namespace Spider {
namespace internal {

/// A point in each lane.
template <typename Scalar>
struct Lane_points
{
  Lanes<Scalar> x, y, z;

  void set(int lane, const Vec3<Scalar>& a)
  {
    x.set(lane, a.x());
    y.set(lane, a.y());
    z.set(lane, a.z());
  }
};

template <typename Scalar>
Lane_points<Scalar> select(const Lane_mask<Scalar>& condition, const Lane_points<Scalar>& a, const Lane_points<Scalar>& b)
{
  return {select(condition, a.x, b.x), select(condition, a.y, b.y), select(condition, a.z, b.z)};
}

/// Coordinates along the axes of a spider's frame, from the query point on and in units of the geodesic radius, so that
/// nothing over- or underflows.
template <typename Scalar>
class Local_coordinates
{
public:
  Local_coordinates(const Vec3<Scalar>& origin, const Spider_frame<Scalar>& frame, Scalar radius)
    : origin_(origin), x_axis_(frame.tangent / radius), y_axis_(frame.bitangent / radius), z_axis_(frame.normal / radius)
  {
    // The error of a coordinate is half an epsilon of its size, and a handful of operations follow.
    constexpr Scalar epsilons = 16;
    rounding_ =
      epsilons * std::numeric_limits<Scalar>::epsilon() * (1 + origin.template lpNorm<Eigen::Infinity>() / radius);
  }

  Vec3<Scalar> operator()(const Vec3<Scalar>& point) const
  {
    const Vec3<Scalar> a = point - origin_;
    return {a.dot(x_axis_), a.dot(y_axis_), a.dot(z_axis_)};
  }

  /// does the same in all lanes.
  Lane_points<Scalar> operator()(const Lane_points<Scalar>& points) const
  {
    using Values = Lanes<Scalar>;
    const Values x = points.x - Values(origin_.x()), y = points.y - Values(origin_.y()),
                 z = points.z - Values(origin_.z());
    const auto along = [&](const Vec3<Scalar>& axis) {
      return x * Values(axis.x()) + y * Values(axis.y()) + z * Values(axis.z());
    };
    return {along(x_axis_), along(y_axis_), along(z_axis_)};
  }

  /// returns the distance at which points are the same but for rounding.
  Scalar rounding() const { return rounding_; }

private:
  Vec3<Scalar> origin_, x_axis_, y_axis_, z_axis_;
  Scalar rounding_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LOCAL_COORDINATES_H
