// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SPIDER_FRAME_H
#define CGAL_SPIDER_INTERNAL_SPIDER_FRAME_H

#include <CGAL/Spider/internal/numbers.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Spider {
namespace internal {

/// A right-handed orthonormal frame at the query point, its first tangent next to a direction that moves with the mesh.
template <typename Scalar>
struct Spider_frame
{
  Vec3<Scalar> tangent, bitangent, normal;

  Spider_frame(const Vec3<Scalar>& unit_normal, const Vec3<Scalar>& reference) : normal(unit_normal)
  {
    // Where the reference nearly is the normal, what rounding leaves is most of the tangent: hence twice.
    tangent = tangential_part(tangential_part(reference));
    if(!tangent.allFinite()) // the reference has no tangential part: any tangent will do
    {
      typename Vec3<Scalar>::Index least;
      normal.cwiseAbs().minCoeff(&least);
      tangent = unit<Scalar>(normal.cross(Vec3<Scalar>::Unit(least)));
    }
    bitangent = normal.cross(tangent);
  }

  /// returns the frame turned the shortest way to another normal. Its directions differ from these no more than the
  /// normals do, whichever of several equal references a frame was made of; projected references would.
  Spider_frame turned_to(const Vec3<Scalar>& unit_normal) const
  {
    const Vec3<Scalar> halfway = normal + unit_normal;
    return {unit_normal, tangent - tangent.dot(unit_normal) / (1 + normal.dot(unit_normal)) * halfway};
  }

  /// returns the direction of what is left of a vector beside the normal; NaN where that is no more than rounding.
  Vec3<Scalar> tangential_part(const Vec3<Scalar>& a) const
  {
    constexpr Scalar rounding = 4 * std::numeric_limits<Scalar>::epsilon(); // of a product of two unit vectors
    const Vec3<Scalar> direction = unit(a), part = direction - direction.dot(normal) * normal;
    return part.norm() > rounding ? unit(part) : nan_vec3<Scalar>();
  }

  Vec3<Scalar> direction(Scalar angle) const { return std::cos(angle) * tangent + std::sin(angle) * bitangent; }
};

/// returns the angle of one of `count` directions spaced regularly over a half turn.
template <typename Scalar>
Scalar angle_of_direction(int index, int count)
{
  const Scalar pi = std::acos(Scalar(-1));
  return pi * index / count;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SPIDER_FRAME_H
