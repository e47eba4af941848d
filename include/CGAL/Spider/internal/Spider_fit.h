// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SPIDER_FIT_H
#define CGAL_SPIDER_INTERNAL_SPIDER_FIT_H

#include <CGAL/Spider/internal/numbers.h>
#include <CGAL/Spider/internal/walk_limb.h>

namespace CGAL {
namespace Spider {
namespace internal {

constexpr int max_polynomial_degree = 4;

/// How far the limbs of a spider got.
template <typename Scalar>
struct Spider_extent
{
  Scalar reached = 0;      ///< by all limbs together, in units of what each was to reach
  bool is_complete = true; ///< all limbs reached the radius
  int number_of_limbs = 0, number_of_walls = 0;
  bool meets_border = false;

  /// adds a limb that reached a share of what it was to. `climbs` tells that it led farther from the tangent plane than
  /// along it.
  void add(Scalar reached_by_limb, Limb_end end, bool climbs = false)
  {
    reached += reached_by_limb;
    is_complete = is_complete && end == radius_reached;
    ++number_of_limbs;
    number_of_walls += end != radius_reached && climbs ? 1 : 0;
    meets_border = meets_border || end == border;
  }

  /// returns the share of the full spider that limbs reached.
  Scalar coverage() const { return reached / Scalar(number_of_limbs); }

  /// tells whether the surface turns back before the radius on most sides. Noise makes some limbs climb, too.
  bool is_walled_in() const { return 2 * number_of_walls > number_of_limbs; }
};

/// What an estimator makes of one spider, in units of the radius. Vectors are in the coordinates (tangent, bitangent,
/// normal) of the spider's frame.
template <typename Scalar>
struct Spider_fit
{
  bool determined = false;
  bool is_whole = true; ///< no term had to be left out
  Scalar min_curvature = nan<Scalar>(), max_curvature = nan<Scalar>();
  Vec3<Scalar> normal = nan_vec3<Scalar>();        ///< from which the next round starts
  Vec3<Scalar> min_direction = nan_vec3<Scalar>(); ///< orthogonal to `normal`; that of `max_curvature` completes them
  Scalar residual = nan<Scalar>();                 ///< root mean square
  Scalar standard_error = nan<Scalar>();           ///< that noise leaves in mean curvature, where the estimator tells
  Scalar independent_values = 0; ///< in how many the samples' noise is independent, where the estimator tells
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SPIDER_FIT_H
