// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The walk of several limbs in lockstep. What one limb does is what `walk_limb()` does, step by step; what differs is
// that nothing branches: limbs that have come to their end stay where they are until all have. And limbs stay in one
// patch: they stop at feature edges at any angle.

#ifndef CGAL_SPIDER_INTERNAL_LIMB_BUNDLE_H
#define CGAL_SPIDER_INTERNAL_LIMB_BUNDLE_H

#include <CGAL/Spider/internal/Circle_watch.h>
#include <CGAL/Spider/internal/Growth_limit.h>
#include <CGAL/Spider/internal/Lane_exits.h>
#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/Segments.h>
#include <CGAL/Spider/internal/Star.h>
#include <CGAL/Spider/internal/walk_limb.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Spider {
namespace internal {

/// Limbs that go in lockstep.
template <typename View>
class Limb_bundle
{
  using Scalar = typename View::Scalar;
  using Halfedge = typename View::Halfedge;
  using Values = Lanes<Scalar>;
  using Mask = Lane_mask<Scalar>;
  using Across = typename Lane_exits<View>::Across;

public:
  /// places limbs at the edges by which they leave the star, in the directions of the given cosines and sines.
  Limb_bundle(const View& view, const Site<View>& site, const Star<View>& star, const Values& cosines,
              const Values& sines, int number_of_limbs, Limb_measure measure)
    : view_(view), local_(star.local), at_(view, site, star, cosines, sines), circles_(at_.edge),
      by_arc_length_(measure == arc_length), y_(0), z_(0), length_(0), height_(0), reached_(0)
  {
    for(int l = 0; l < number_of_lanes; ++l)
      growing_.set(l, l < number_of_limbs);
    growing_ = growing_ & at_.is_near(at_.source) & at_.is_near(at_.target);
    end_.fill(site.end_at_once);
    if(view_.has_growth_costs())
      enter_faces(growing_);
    at_.lead_to_query_point(!growing_);
  }

  /// walks all limbs to the radius, or to their ends, and calls `visit(segments)` for every step in lockstep.
  template <typename Visitor>
  void walk(Visitor&& visit)
  {
    constexpr std::array<Scalar, 1> radius = {1};
    walk(radius, visit, [](int, std::size_t) {});
  }

  /// walks all limbs to each of some shares of the radius, which ascend to 1, or to their ends. It calls
  /// `visit(segments)` for every step in lockstep and, once for every limb and share, `arrive(lane, index)` where the
  /// limb has come that far, or will come no farther.
  template <typename Shares, typename Visitor, typename Arrival>
  void walk(const Shares& shares, Visitor&& visit, Arrival&& arrive)
  {
    std::array<std::size_t, number_of_lanes> next{};
    set_share_of_radius(Values(shares[0]));
    while(growing_.any())
    {
      step(visit);
      if(shares.size() > 1 && resting_.any())
        send_on(shares, next, arrive);
    }
    for(int l = 0; l < number_of_lanes; ++l)
      for(; next[l] < shares.size(); ++next[l])
        arrive(l, next[l]);
  }

  /// walks each limb to its own share of the radius, or to its end, and calls `visit(segments)` for every step in
  /// lockstep.
  template <typename Visitor>
  void walk_each(const Values& shares, Visitor&& visit)
  {
    set_share_of_radius(shares);
    while(growing_.any())
      step(visit);
  }

  Scalar reached(int lane) const { return reached_[lane]; }
  Limb_end end(int lane) const { return complete_[lane] ? radius_reached : end_[lane]; }
  /// tells whether a limb has led farther from the tangent plane than along it.
  bool climbs(int lane) const { return height_[lane] > reached_[lane]; }
  const Values& end_along_direction() const { return y_; }
  const Values& end_along_normal() const { return z_; }

private:
  void set_share_of_radius(const Values& share)
  {
    share_of_radius_ = share;
    limit_.set_radius(share);
  }

  template <typename Visitor>
  void step(Visitor&& visit)
  {
    const Across across = at_.look_across(view_, local_);
    visit(take_segments());
    cross_edges(across);
    circles_.note_step(at_.edge);
  }

  Segments<Scalar> take_segments()
  {
    const Values zero(0), one(1);
    const Values crossing = at_.source_side / (at_.source_side - at_.target_side);
    const Values x = between(at_.source.x, at_.target.x, crossing), y = between(at_.source.y, at_.target.y, crossing);
    const Values exit = at_.along(x, y), y_step = exit - y_, z_step = between(at_.source.z, at_.target.z, crossing) - z_;
    const Values step = square_root(y_step * y_step + z_step * z_step);

    const Values advance = by_arc_length_ ? step : y_step, from = by_arc_length_ ? reached_ : y_;
    const Values to = from + advance, inverse = one / select(advance > zero, advance, Values(infinity()));
    const Mask is_last = growing_ & (to >= limit_.limit());
    const Values share = select(is_last, (limit_.limit() - from) * inverse, select(growing_, one, zero));
    const Values arrived = select(is_last, limit_.limit(), to), begin = larger(from, reached_);
    const Values middle_share = (smaller((begin - from) * inverse, share) + share) * Values(Scalar(0.5));
    const Values gain = select(growing_, larger(arrived - begin, zero), zero);
    const Segments<Scalar> segments{
      at_.source, at_.target, crossing, share, gain, middle_share, y_ + middle_share * y_step, y_, exit};

    y_ = y_ + share * y_step;
    z_ = z_ + share * z_step;
    length_ = length_ + share * step;
    height_ = larger(height_, absolute(z_));
    reached_ = select(growing_, larger(reached_, arrived), reached_);
    const Mask is_too_long = growing_ & (length_ > Values(longest_limb_in_radii) * share_of_radius_);
    resting_ = is_last | is_too_long;
    growing_ = growing_ & !resting_;
    const Mask completes = is_last & !(limit_.limit() < share_of_radius_), is_slowed = resting_ & !completes;
    complete_ = complete_ | completes;
    if(is_slowed.any())
      note_end(is_slowed, slowed);
    return segments;
  }

  /// has limbs that rest at one share of the radius go on to the next, if there is one.
  template <typename Shares, typename Arrival>
  void send_on(const Shares& shares, std::array<std::size_t, number_of_lanes>& next, Arrival&& arrive)
  {
    for(int l = 0; l < number_of_lanes; ++l)
    {
      if(!resting_[l] || next[l] + 1 == shares.size())
        continue;
      arrive(l, next[l]);
      share_of_radius_.set(l, shares[++next[l]]);
      growing_.set(l, true);
    }
    limit_.set_radius(share_of_radius_);
    complete_ = complete_ & !growing_;
  }

  /// crosses edges into the next faces and finds the edges by which the planes leave those.
  void cross_edges(const Across& across)
  {
    const Mask goes_on = at_.cross(across, growing_ & !closed_), stops = growing_ & !goes_on;
    if(stops.any())
      note_stops(stops);
    if((goes_on & (circles_.are_first(at_.edge) | circles_.are_passed(at_.edge))).any())
      note_circles();
    if(view_.has_growth_costs())
      enter_faces(goes_on);
  }

  /// has the next segments cost as many times their length as the faces tell, and ends limbs in faces of infinite cost.
  void enter_faces(const Mask& entering)
  {
    Values costs = limit_.cost();
    for(int l = 0; l < number_of_lanes; ++l)
    {
      if(!entering[l])
        continue;
      const Scalar cost = view_.growth_cost(at_.edge[l]);
      if(std::isfinite(cost))
        costs.set(l, cost);
      else
      {
        growing_.set(l, false);
        end_[l] = slowed;
      }
    }
    limit_.enter(costs, reached_);
  }

  void note_end(const Mask& of_limbs, Limb_end end)
  {
    for(int l = 0; l < number_of_lanes; ++l)
      end_[l] = of_limbs[l] ? end : end_[l];
  }

  /// ends limbs that left the mesh, whose sections are closed, or that lost their way.
  void note_stops(const Mask& stops)
  {
    for(int l = 0; l < number_of_lanes; ++l)
      if(stops[l])
        end_[l] = closed_[l] ? degenerate : end_at(at_.edge[l]);
    growing_ = growing_ & !stops;
  }

  Limb_end end_at(Halfedge h) const
  {
    if(view_.opposite(h) == View::null_halfedge())
      return border;
    return view_.is_feature(h) ? feature_edge : view_.is_closed_to_growth(h) ? slowed : degenerate;
  }

  /// Limbs that are back at the edge where they began lead to the query point, where their sections close. Those that
  /// go round in circles elsewhere end.
  void note_circles()
  {
    const Mask closes = growing_ & circles_.are_first(at_.edge);
    const Mask ends = growing_ & !closes & circles_.are_passed(at_.edge);
    note_end(ends, degenerate);
    closed_ = closed_ | closes;
    growing_ = growing_ & !ends;
    at_.lead_to_query_point(closes);
  }

  static Values between(const Values& from, const Values& to, const Values& share)
  {
    return from + share * (to - from);
  }
  static constexpr Scalar infinity() { return std::numeric_limits<Scalar>::infinity(); }

  const View& view_;
  const Local_coordinates<Scalar>& local_;
  Lane_exits<View> at_;
  Circle_watch<View> circles_;
  bool by_arc_length_;
  Values y_, z_;                     ///< where the limb is, along its direction and the normal
  Values length_, height_, reached_; ///< how long it is, how far from the tangent plane it was, and how far it came
  Growth_limit<Values> limit_;
  Values share_of_radius_; ///< that is walked to
  Mask growing_{}, closed_{};
  /// A limb rests after the step that led it as far as is walked, and is complete if it came that far.
  Mask resting_{}, complete_{};
  std::array<Limb_end, number_of_lanes> end_; ///< of those that aren't complete
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LIMB_BUNDLE_H
