// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Of all vertices that a spider meets, those of the faces where limbs end tell most of curvature under noise: they are
// farthest away. What limbs see of these faces without going farther than the radius is how high they are, and how
// steep.

#ifndef CGAL_SPIDER_INTERNAL_LIMB_ENDS_H
#define CGAL_SPIDER_INTERNAL_LIMB_ENDS_H

#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/Segments.h>

#include <array>

namespace CGAL {
namespace Spider {
namespace internal {

/// A sample that is farther from the tangent plane than from the normal's line lies on a wall, and counts the less the
/// steeper it is seen from the query point: not at all from a slope of 1.5 on, long before limbs that climb get too
/// long.
template <typename Scalar>
Lanes<Scalar> weight_by_slope(const Lanes<Scalar>& y, const Lanes<Scalar>& z)
{
  using Values = Lanes<Scalar>;
  constexpr Scalar steepest = Scalar(1.5), width_of_fading = steepest - 1;
  const Values zero(0), one(1), rise = absolute(z), way = larger(y, zero);
  const Lane_mask<Scalar> climbs = rise > way;
  if(!climbs.any())
    return one;
  return select(climbs, larger((Values(steepest) - rise / way) * Values(1 / width_of_fading), zero), one);
}

/// Functions of which the last is the height, where limbs in lockstep end, and their slopes there along the limbs.
///
/// Answers mustn't jump where limbs get to enter other faces, or turn back on folds before the radius. So a face counts
/// but little where limbs have gained but little in it, and the ends of limbs that turn back stay where they turned.
template <typename Scalar, int Number>
class Limb_ends
{
  using Values = Lanes<Scalar>;
  static constexpr int height = Number - 1;

public:
  using Functions = std::array<Values, Number>;

  /// starts at the query point.
  void clear(const Functions& origin)
  {
    functions_ = origin;
    slopes_.fill(Values(0));
    y_ = slope_of_y_ = reached_ = Values(0);
  }

  /// follows the next segments, given the functions where these start and where limbs get on them. A segment counts
  /// fully if it gains the given stretch.
  void follow(const Segments<Scalar>& next, const Functions& from, const Functions& to, Scalar stretch)
  {
    const Values one(1), run = next.share * (next.exit - next.start), rise = to[height] - from[height];
    const Values y = next.start + run, gain = next.gain * weight_by_slope(y, to[height]);
    const Values share = smaller(gain * Values(1 / stretch), one);
    // Slopes count by the square of the cosine, lest a steep face has more than its share.
    const Values square = run * run + rise * rise, share_by_run = share * run / select(square > Values(0), square, one);
    const Values share_of_slope = share_by_run * run;
    CGAL_SPIDER_FOR_EACH(k, 0, Number)
    {
      functions_[k] += share * (to[k] - functions_[k]);
      slopes_[k] += share_by_run * (to[k] - from[k]) - share_of_slope * slopes_[k];
    }
    y_ += share * (y - y_);
    slope_of_y_ += share_of_slope * (one - slope_of_y_);
    reached_ += gain;
  }

  /// takes over one limb.
  void take_lane(int lane, const Limb_ends& other)
  {
    for(int k = 0; k < Number; ++k)
    {
      functions_[k].set(lane, other.functions_[k][lane]);
      slopes_[k].set(lane, other.slopes_[k][lane]);
    }
    y_.set(lane, other.y_[lane]);
    slope_of_y_.set(lane, other.slope_of_y_[lane]);
    reached_.set(lane, other.reached_[lane]);
  }

  /// returns the distance, or a function, and the given length times its slope.
  Values y_and_slope(const Values& length) const { return y_ + length * slope_of_y_; }
  Values function_and_slope(int k, const Values& length) const { return functions_[k] + length * slopes_[k]; }

  /// returns which share of their ends limbs have that were to reach the given distances: all where they did, and the
  /// less the earlier they turned back or stopped.
  Values share_of(const Values& to_reach) const
  {
    constexpr Scalar just_before = Scalar(0.1); // of the distance
    const Values zero(0), one(1), lack = one - reached_ / select(to_reach > zero, to_reach, one);
    return larger(one - lack * Values(1 / just_before), zero);
  }

private:
  Functions functions_, slopes_;
  Values y_, slope_of_y_; ///< how far ends are along the limbs' directions, and the slope of that, which becomes 1
  Values reached_;        ///< how far limbs got
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LIMB_ENDS_H
