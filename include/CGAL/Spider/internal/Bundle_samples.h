// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the samples of limbs in lockstep leave behind for `surface_fit`: sums of powers, limb by limb in lanes.
//
// - A sample at the distance y is weighed by y, so that every piece of area counts the same. Limbs' ends weigh more, and
//   the slopes of the faces there count too.
// - Facets sag below the surface that they stand for. So a sample isn't compared with the height field, but with the
//   mesh that one would get by moving the vertices onto the height field: the terms are interpolated along edges and
//   along the limb as heights are. A mesh of an exact polynomial of the fitted degree gives that polynomial.
// - Walls are no part of a height field. Samples fade out where limbs climb more than they lead along, and little by
//   little, lest answers jump where a limb comes to lie on the other side of a fold.

#ifndef CGAL_SPIDER_INTERNAL_BUNDLE_SAMPLES_H
#define CGAL_SPIDER_INTERNAL_BUNDLE_SAMPLES_H

#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/Limb_ends.h>
#include <CGAL/Spider/internal/Limb_moments.h>
#include <CGAL/Spider/internal/Sample_sizes.h>
#include <CGAL/Spider/internal/Segments.h>
#include <CGAL/Spider/internal/height_field.h>

namespace CGAL {
namespace Spider {
namespace internal {

/// A segment at the distance y from the query point stands for an area, in proportion to y. Long ones tell more than
/// short ones, but less than by their length, since they see the same few vertices: they count by its root. Only those
/// that are shorter than `short_length` count by their length, lest rounding counts where a limb passes through a
/// vertex.
template <typename Scalar>
Lanes<Scalar> weight_by_area(const Lanes<Scalar>& length, Scalar short_length)
{
  return Lanes<Scalar>(1) / square_root(length + Lanes<Scalar>(short_length));
}

/// The samples of limbs in lockstep, one in the middle of each segment, for a height field of the given degree.
template <typename Scalar, int Degree>
class Bundle_samples
{
  using Values = Lanes<Scalar>;
  using Basis = Height_field_basis<Degree>;
  using Moments = Limb_moments<Scalar, Degree>;

public:
  /// The curved terms and the height.
  using Functions = typename Moments::Functions;

  /// starts without any sample, at the query point.
  void clear(const Functions& origin)
  {
    moments_.clear();
    sizes_ = {};
    here_ = origin;
    ends_.clear(origin);
  }

  /// adds a sample in the middle of the next segment of each limb.
  void add(const Segments<Scalar>& next, Scalar short_length)
  {
    const auto source = Basis::curved_at(next.source.x, next.source.y);
    const auto target = Basis::curved_at(next.target.x, next.target.y);
    const Functions start = here_;
    Functions middle;
    CGAL_SPIDER_FOR_EACH(k, 0, Basis::curved + 1)
    {
      const Values exit = k < Basis::curved ? between(source[k], target[k], next.crossing)
                                            : between(next.source.z, next.target.z, next.crossing);
      middle[k] = between(start[k], exit, next.middle_share);
      here_[k] = between(start[k], exit, next.share);
    }
    // A stretch of three hundredths of the radius, with which answers change by less than a twentieth along paths over
    // a noisy scan. With two, errors are 1 % smaller.
    ends_.follow(next, start, here_, 3 * short_length);
    const Values area = next.middle * next.gain, by_area = weight_by_area(next.gain, short_length) *
                                                           weight_by_slope(next.middle, middle[Moments::height]);
    moments_.add(next.middle, middle, area * by_area);
    sizes_.add(area, next.gain, by_area);
  }

  /// takes over the samples of one limb, which are complete.
  void take_lane(int lane, const Bundle_samples& other)
  {
    moments_.take_lane(lane, other.moments_);
    sizes_.take_lane(lane, other.sizes_);
    ends_.take_lane(lane, other.ends_);
  }

  /// notes how far a limb was to get.
  void set_reach(int lane, Scalar to_reach) { to_reach_.set(lane, to_reach); }

  /// adds a sample at each limb's end, with the slope there times a length. It weighs as many times as much as a
  /// segment of another length as is given.
  void add_ends(Scalar length, Scalar weight, Scalar length_by_slope, Scalar short_length)
  {
    const Values times_slope(length_by_slope), y = ends_.y_and_slope(times_slope);
    Functions functions;
    for(int k = 0; k <= Basis::curved; ++k)
      functions[k] = ends_.function_and_slope(k, times_slope);
    const Values areas = ends_.share_of(to_reach_) * Values(length);
    const Values by_area =
      Values(weight) * weight_by_area(Values(length), short_length) * weight_by_slope(y, functions[Moments::height]);
    moments_.add(y, functions, areas * by_area);
    sizes_.add_weight(areas, by_area);
  }

  const Moments& moments() const { return moments_; }
  const Sample_sizes<Scalar>& sizes() const { return sizes_; }

private:
  static Values between(const Values& from, const Values& to, const Values& share)
  {
    return from + share * (to - from);
  }

  Moments moments_;
  Functions here_;  ///< where limbs are
  Values to_reach_; ///< how far limbs were to get
  Limb_ends<Scalar, Basis::curved + 1> ends_;
  Sample_sizes<Scalar> sizes_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_BUNDLE_SAMPLES_H
