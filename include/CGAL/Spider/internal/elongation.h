// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Spiders that are longer along one direction than across it. How much shorter limbs are is a quadratic form of their
// directions: along a unit vector d, they reach a share 1 / sqrt(1 + d' S d) of the radius. S is zero for a disc, and
// (l^2 - 1) (I - e e') for an ellipse that is l times as long along e as across. Forms can be interpolated, as axes,
// which have no sign, cannot.

#ifndef CGAL_SPIDER_INTERNAL_ELONGATION_H
#define CGAL_SPIDER_INTERNAL_ELONGATION_H

#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/numbers.h>

#include <algorithm>

namespace CGAL {
namespace Spider {
namespace internal {

template <typename Scalar>
using Shortening = Eigen::Matrix<Scalar, 3, 3>;

/// returns the form of an ellipse with the given long axis, that is as many times as long along it as across as the
/// vector is long. A vector that isn't longer than 1, or isn't finite, is for a disc.
template <typename Scalar>
Shortening<Scalar> shortening_across(const Vec3<Scalar>& axis)
{
  constexpr Scalar longest = 8; // in a narrower ellipse, hardly one of sixteen directions would be along it
  const Scalar elongation = std::min(axis.stableNorm(), longest);
  const Vec3<Scalar> e = unit(axis);
  if(!(elongation > 1) || !e.allFinite())
    return Shortening<Scalar>::Zero();
  return (elongation * elongation - 1) * (Shortening<Scalar>::Identity() - e * e.transpose());
}

/// returns which shares of the radius limbs reach in the directions of the given cosines and sines.
template <typename Scalar>
Lanes<Scalar> shares_reached(const Shortening<Scalar>& shortening, const Spider_frame<Scalar>& frame,
                             const Lanes<Scalar>& cosines, const Lanes<Scalar>& sines)
{
  const Vec3<Scalar> by_tangent = shortening * frame.tangent, by_bitangent = shortening * frame.bitangent;
  const Lanes<Scalar> one(1), along_tangent(frame.tangent.dot(by_tangent)),
    along_both(2 * frame.bitangent.dot(by_tangent)), along_bitangent(frame.bitangent.dot(by_bitangent));
  return one / square_root(one + cosines * cosines * along_tangent + cosines * sines * along_both +
                           sines * sines * along_bitangent);
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_ELONGATION_H
