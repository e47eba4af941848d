// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the samples of limbs in lockstep leave behind for `surface_fit`: sums of powers, limb by limb in lanes.
//
// - A sample at the distance y is weighed by y, so that every piece of area counts the same. The rim weighs more: there
//   a sample also stands for the vertices beyond.
// - Facets sag below the surface that they stand for. So a sample isn't compared with the height field, but with the
//   mesh that one would get by moving the vertices onto the height field: the terms are interpolated along edges and
//   along the limb as heights are. A mesh of an exact polynomial of the fitted degree gives that polynomial.
// - Walls are no part of a height field. Samples fade out where limbs climb more than they lead along, and little by
//   little, lest answers jump where a limb comes to lie on the other side of a fold.

#ifndef CGAL_SPIDER_INTERNAL_BUNDLE_SAMPLES_H
#define CGAL_SPIDER_INTERNAL_BUNDLE_SAMPLES_H

#include <CGAL/Spider/internal/Lanes.h>
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

/// The samples of limbs in lockstep, one in the middle of each segment, for a height field of the given degree.
template <typename Scalar, int Degree>
class Bundle_samples
{
  using Values = Lanes<Scalar>;
  using Basis = Height_field_basis<Degree>;
  using Moments = Limb_moments<Scalar, Degree>;

public:
  /// The curved terms and the height, at the limbs' ends.
  using Functions = typename Moments::Functions;

  /// starts without any sample, at the query point.
  void clear(const Functions& origin)
  {
    moments_.clear();
    sizes_ = {};
    at_end_ = at_exit_ = at_turn_ = origin;
    reached_ = last_gain_ = turned_at_ = entry_ = exit_ = Values(0);
  }

  /// adds a sample in the middle of the next segment of each limb.
  void add(const Segments<Scalar>& next, Scalar short_length)
  {
    note_turns(next);
    const auto source = Basis::curved_at(next.source.x, next.source.y);
    const auto target = Basis::curved_at(next.target.x, next.target.y);
    Functions middle;
    CGAL_SPIDER_FOR_EACH(k, 0, Basis::curved + 1)
    {
      const Values crossing = k < Basis::curved ? between(source[k], target[k], next.crossing)
                                                : between(next.source.z, next.target.z, next.crossing);
      middle[k] = between(at_end_[k], crossing, next.middle_share);
      at_end_[k] = between(at_end_[k], crossing, next.share);
      at_exit_[k] = crossing;
    }
    exit_ = next.exit;
    entry_ = select(next.share < Values(1), entry_, exit_);
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
    turned_at_.set(lane, other.turned_at_[lane]);
    entry_.set(lane, other.entry_[lane]);
    exit_.set(lane, other.exit_[lane]);
    for(int k = 0; k <= Basis::curved; ++k)
    {
      at_end_[k].set(lane, other.at_end_[k][lane]);
      at_exit_[k].set(lane, other.at_exit_[k][lane]);
      at_turn_[k].set(lane, other.at_turn_[k][lane]);
    }
  }

  /// notes where a limb ended, along its direction.
  void end_lane(int lane, Scalar end, bool is_complete)
  {
    end_.set(lane, end);
    is_complete_.set(lane, is_complete ? 1 : 0);
  }

  /// adds a sample at the rim of the faces where complete limbs end, though no farther from these ends than the given
  /// length; it stands for an area and is weighed by that. A limb that turned back just before the radius has it where
  /// it turned, all of it if that was at the radius: there limbs end that reach it before they turn, and others go on
  /// to the far side of a fold.
  void add_rim(Scalar area, const Values& weight_by_area, Scalar radius, Scalar farthest)
  {
    constexpr Scalar just_before = Scalar(0.1); // of the radius
    const Values one(1), zero(0), lack = one - turned_at_ * Values(1 / radius);
    const Values share_at_turn = larger(one - lack * Values(1 / just_before), zero);
    if((share_at_turn > zero).any())
      add_at_rim(turned_at_, at_turn_, share_at_turn * Values(area), weight_by_area);
    const Values beyond = beyond_end(farthest), way = exit_ - end_;
    const Values share = beyond / select(way > zero, way, one);
    Functions at_rim;
    for(int k = 0; k <= Basis::curved; ++k)
      at_rim[k] = between(at_end_[k], at_exit_[k], share);
    add_at_rim(end_ + beyond, at_rim, (one - share_at_turn) * is_complete_ * Values(area), weight_by_area);
  }

  const Moments& moments() const { return moments_; }
  const Sample_sizes<Scalar>& sizes() const { return sizes_; }

private:
  /// Where limbs begin to turn back, they are as far as they got.
  void note_turns(const Segments<Scalar>& next)
  {
    const Values zero(0);
    const Lane_mask<Scalar> turns = (last_gain_ > zero) & (next.share > zero) & !(next.gain > zero);
    if(turns.any())
    {
      turned_at_ = select(turns, reached_, turned_at_);
      for(int k = 0; k <= Basis::curved; ++k)
        at_turn_[k] = select(turns, at_end_[k], at_turn_[k]);
    }
    reached_ += next.gain;
    last_gain_ = next.gain;
  }

  /// returns how far beyond their ends limbs would leave the faces where they end, at most the given length: not before
  /// they came some of their way through these, lest answers jump where limbs enter others.
  Values beyond_end(Scalar farthest) const
  {
    constexpr Scalar some = Scalar(1) / 3; // of the way
    const Values zero(0), one(1), way_through = exit_ - entry_;
    const Values share_of_way = larger(end_ - entry_, zero) / select(way_through > zero, way_through, one);
    return smaller(share_of_way * Values(1 / some), one) * larger(smaller(exit_ - end_, Values(farthest)), zero);
  }

  void add_at_rim(const Values& y, const Functions& functions, const Values& areas, const Values& weight_by_area)
  {
    const Values by_area = weight_by_area * weight_by_slope(y, functions[Moments::height]);
    moments_.add(y, functions, areas * by_area);
    sizes_.add_weight(areas, by_area);
  }

  static Values between(const Values& from, const Values& to, const Values& share)
  {
    return from + share * (to - from);
  }

  Moments moments_;
  Functions at_end_, at_exit_, at_turn_;
  Values reached_, last_gain_; ///< how far limbs got, and what their last segments added
  Values turned_at_;           ///< where they last turned back, 0 if they never did
  Values end_;                 ///< how far along their directions they got
  Values entry_, exit_;        ///< where along them limbs enter the faces where they end, and would leave these
  Values is_complete_;
  Sample_sizes<Scalar> sizes_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_BUNDLE_SAMPLES_H
