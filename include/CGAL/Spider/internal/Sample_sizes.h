// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// In how many values the noise of samples is independent: far fewer than there are samples, which are interpolated from
// the same few vertices. It is told from the lengths of segments alone, so that it changes little by little where a
// limb comes to lie on the other side of a vertex.

#ifndef CGAL_SPIDER_INTERNAL_SAMPLE_SIZES_H
#define CGAL_SPIDER_INTERNAL_SAMPLE_SIZES_H

#include <CGAL/Spider/internal/Lanes.h>

#include <CGAL/number_type_config.h>

namespace CGAL {
namespace Spider {
namespace internal {

/// Sums over the samples of limbs in lockstep, each in the middle of a segment of the length l at the distance y from
/// the query point: it stands for an area in proportion to y l, by which its weight w is. Lengths are in units of the
/// radius.
template <typename Scalar>
struct Sample_sizes
{
  using Values = Lanes<Scalar>;

  Values areas{0}, cubed_lengths{0};     ///< sums of y l and of y l^3
  Values squares{0}, squares_by_area{0}; ///< sums of w^2 and of w^2 / (y l)

  void add(const Values& area, const Values& length, const Values& weight_by_area)
  {
    areas += area;
    cubed_lengths += area * length * length;
    add_weight(area, weight_by_area);
  }

  /// adds a sample whose segment isn't to count for the size of triangles.
  void add_weight(const Values& area, const Values& weight_by_area)
  {
    const Values weight = area * weight_by_area;
    squares += weight * weight;
    squares_by_area += weight * weight_by_area;
  }

  void take_lane(int lane, const Sample_sizes& other)
  {
    areas.set(lane, other.areas[lane]);
    cubed_lengths.set(lane, other.cubed_lengths[lane]);
    squares.set(lane, other.squares[lane]);
    squares_by_area.set(lane, other.squares_by_area[lane]);
  }

  void operator+=(const Sample_sizes& other)
  {
    areas += other.areas;
    cubed_lengths += other.cubed_lengths;
    squares += other.squares;
    squares_by_area += other.squares_by_area;
  }

  /// returns twice the area of a triangle, on average over the spider's area. By lines in all places and directions,
  /// the mean cube of a triangle's chords is 3 / pi times its area times their mean (Crofton).
  Scalar doubled_area() const { return Scalar(2 * CGAL_PI / 3) * cubed_lengths.sum() / areas.sum(); }

  /// returns in how many values noise is independent, given the sum of weights. A mesh has half as many vertices as
  /// triangles, so in the area between limbs that a sample stands for, there are as many as doubled areas. Where these
  /// are few, its neighbours see the same ones; where they are many, it sees but about one of them.
  Scalar independent_values(Scalar sum_of_weights, Scalar angle_between_limbs) const
  {
    return sum_of_weights * sum_of_weights /
           (squares.sum() + doubled_area() / angle_between_limbs * squares_by_area.sum());
  }
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SAMPLE_SIZES_H
