// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The walk of several limbs in lockstep. What one limb does is what `walk_limb()` does, step by step; what differs is that
// nothing branches: limbs that have come to their end stay where they are until all have.

#ifndef CGAL_SPIDER_INTERNAL_LIMB_BUNDLE_H
#define CGAL_SPIDER_INTERNAL_LIMB_BUNDLE_H

#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/Star.h>
#include <CGAL/Spider/internal/walk_limb.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Spider {
namespace internal {

/// The next segment of each limb: it leads towards the crossing of an edge.
template <typename Scalar>
struct Segments
{
  const Lane_points<Scalar>&source, &target; ///< ends of the edge
  Lanes<Scalar> crossing;                    ///< where on the edge, from 0 at its source to 1 at its target
  Lanes<Scalar> share;                       ///< how much of the way there is taken; 0 by limbs that have ended
  Lanes<Scalar> gain;                        ///< how much farther it gets than before, by the limb's measure
  Lanes<Scalar> middle_share;                ///< how much of the way leads to the middle of that
  Lanes<Scalar> middle;                      ///< how far along the limb's direction the middle of that is
};

template <typename View>
class Limb_bundle
{
  using Scalar = typename View::Scalar;
  using Halfedge = typename View::Halfedge;
  using Values = Lanes<Scalar>;
  using Mask = Lane_mask<Scalar>;

public:
  /// places limbs at the edges by which they leave the star, in the directions of the given cosines and sines.
  Limb_bundle(const View& view,
              const Site<View>& site,
              const Star<View>& star,
              const Values& cosines,
              const Values& sines,
              int number_of_limbs,
              Limb_measure measure)
    : view_(view), local_(star.local), cosine_(cosines), sine_(sines), shift_(star.local.rounding()),
      by_arc_length_(measure == arc_length), y_(0), z_(0), length_(0), reached_(0),
      growing_(Values(1) > Values(0)), closed_(!growing_)
  {
    leave_star(site, star, number_of_limbs);
    checkpoint_ = first_edge_ = edge_;
  }

  /// walks all limbs to their ends and calls `visit(segments)` for every step in lockstep.
  template <typename Visitor>
  void walk(Visitor&& visit)
  {
    std::size_t steps = 0, next_checkpoint = 1;
    while(growing_.any())
    {
      visit(take_segments());
      cross_edges();
      if(++steps == next_checkpoint) // should a walk go round in a circle, it will be back here
      {
        checkpoint_ = edge_;
        next_checkpoint *= 2;
      }
    }
  }

  Scalar reached(int lane) const { return reached_[lane]; }
  Limb_end end(int lane) const { return end_[lane]; }
  const Values& end_along_direction() const { return y_; }
  Values is_complete() const
  {
    Values complete;
    for(int l = 0; l < number_of_lanes; ++l)
      complete.set(l, end_[l] == radius_reached ? 1 : 0);
    return complete;
  }

private:
  /// Beyond, squares of what is made of coordinates would overflow.
  static constexpr Scalar farthest() { return Scalar(1e30); }

  /// finds the edges by which the limbs leave the star: among those that its rim offers, as `first_exit()` does, where
  /// there is one and no doubt of it.
  void leave_star(const Site<View>& site, const Star<View>& star, int number_of_limbs)
  {
    const Mask none = !growing_, all = growing_;
    Mask offered = none, doubtful = none;
    for(int l = 0; l < number_of_lanes; ++l)
    {
      edge_[l] = site.rim.front();
      end_[l] = degenerate;
    }
    source_ = target_ = {Values(0), Values(0), Values(0)};
    source_side_ = Values(1);
    target_side_ = Values(0);
    for(const Star_edge<View>& e : star.edges)
    {
      const Values sx(e.source.x()), sy(e.source.y()), tx(e.target.x()), ty(e.target.y());
      const Values s_side = side(sx, sy), t_side = side(tx, ty), a_side = side(e.apex.x(), e.apex.y());
      const Mask crosses = !((s_side >= Values(0)) == (t_side >= Values(0)));
      if(!crosses.any())
        continue;
      const Values s_along = along(sx, sy), t_along = along(tx, ty), a_along = along(e.apex.x(), e.apex.y());
      const Values turn = (t_along - s_along) * (a_side - s_side) - (t_side - s_side) * (a_along - s_along);
      const Values size = absolute(t_along - s_along) + absolute(t_side - s_side);
      const Mask ahead = crosses & ((turn > Values(0)) == (t_side >= Values(0)));
      doubtful = doubtful | (offered & ahead) | (crosses & !(absolute(turn) > Values(local_.rounding()) * size));
      offered = offered | ahead;
      replace(source_, source_side_, ahead, {sx, sy, Values(e.source.z())}, s_side);
      replace(target_, target_side_, ahead, {tx, ty, Values(e.target.z())}, t_side);
      for(int l = 0; l < number_of_lanes; ++l)
        edge_[l] = ahead[l] ? e.edge : edge_[l];
    }
    doubtful = doubtful | !offered;
    if(doubtful.any())
      for(int l = 0; l < number_of_limbs; ++l)
        if(doubtful[l])
          leave_star_in_doubt(l, site);
    Values is_limb(1);
    for(int l = number_of_limbs; l < number_of_lanes; ++l)
      is_limb.set(l, 0);
    growing_ = all & (is_limb > Values(0)) & is_near(source_) & is_near(target_);
    lead_to_query_point(!growing_);
  }

  void leave_star_in_doubt(int l, const Site<View>& site)
  {
    Cut<Scalar> cut(local_, cosine_[l], sine_[l]);
    const Exit<View> exit = first_exit_either_way(view_, site, cut);
    shift_.set(l, cut.shift());
    end_[l] = site.on_border ? border : degenerate;
    if(!exit.exists())
    {
      source_.set(l, nan_vec3<Scalar>()); // not near
      return;
    }
    edge_[l] = exit.edge;
    source_.set(l, local_(view_.point(view_.source(exit.edge))));
    target_.set(l, local_(view_.point(view_.target(exit.edge))));
    source_side_.set(l, exit.source.side);
    target_side_.set(l, exit.target.side);
  }

  /// has limbs lead back to the query point.
  void lead_to_query_point(const Mask& which)
  {
    const Lane_points<Scalar> query_point = {Values(0), Values(0), Values(0)};
    replace(source_, source_side_, which, query_point, Values(1));
    replace(target_, target_side_, which, query_point, Values(0));
  }

  static void replace(Lane_points<Scalar>& point,
                      Values& side,
                      const Mask& which,
                      const Lane_points<Scalar>& new_point,
                      const Values& new_side)
  {
    point.x = select(which, new_point.x, point.x);
    point.y = select(which, new_point.y, point.y);
    point.z = select(which, new_point.z, point.z);
    side = select(which, new_side, side);
  }

  Values side(const Values& x, const Values& y) const { return cosine_ * y - sine_ * x + shift_; }
  Values along(const Values& x, const Values& y) const { return cosine_ * x + sine_ * y; }

  static Mask is_near(const Lane_points<Scalar>& a)
  {
    return absolute(a.x) + absolute(a.y) + absolute(a.z) < Values(farthest());
  }

  Segments<Scalar> take_segments()
  {
    const Values zero(0), one(1);
    const Values crossing = source_side_ / (source_side_ - target_side_);
    const Values x = between(source_.x, target_.x, crossing), y = between(source_.y, target_.y, crossing);
    const Values y_step = along(x, y) - y_, z_step = between(source_.z, target_.z, crossing) - z_;
    const Values step = square_root(y_step * y_step + z_step * z_step);

    const Values advance = by_arc_length_ ? step : y_step, from = by_arc_length_ ? reached_ : y_;
    const Values to = from + advance, inverse = one / select(advance > zero, advance, Values(infinity()));
    const Mask is_last = growing_ & (to >= one);
    const Values share = select(is_last, (one - from) * inverse, select(growing_, one, zero));
    const Values arrived = select(is_last, one, to), begin = larger(from, reached_);
    const Values middle_share = (smaller((begin - from) * inverse, share) + share) * Values(Scalar(0.5));
    const Values gain = select(growing_, larger(arrived - begin, zero), zero);
    const Segments<Scalar> segments{source_, target_, crossing, share, gain, middle_share, y_ + middle_share * y_step};

    y_ = y_ + share * y_step;
    z_ = z_ + share * z_step;
    length_ = length_ + share * step;
    reached_ = select(growing_, larger(reached_, arrived), reached_);
    const Mask is_too_long = growing_ & (length_ > Values(longest_limb_in_radii)), ended = is_last | is_too_long;
    if(ended.any())
    {
      for(int l = 0; l < number_of_lanes; ++l)
        end_[l] = is_last[l] ? radius_reached : ended[l] ? slowed : end_[l];
      growing_ = growing_ & !ended;
    }
    return segments;
  }

  /// crosses edges into the next faces and finds the edges by which the planes leave those.
  void cross_edges()
  {
    Lanes_of_halfedges third;
    std::array<Scalar, number_of_lanes> x, y, z;
    for(int l = 0; l < number_of_lanes; ++l)
    {
      const auto beyond = view_.beyond(edge_[l]);
      third[l] = beyond.third;
      x[l] = beyond.apex.x();
      y[l] = beyond.apex.y();
      z[l] = beyond.apex.z();
    }
    const Lane_points<Scalar> apex = local_({Values(x), Values(y), Values(z)});
    const Values apex_side = side(apex.x, apex.y), zero(0);
    const Mask goes_on = growing_ & !closed_ & is_near(apex), stops = growing_ & !goes_on;
    const Mask is_of_source = (source_side_ >= zero) == (apex_side >= zero);
    const Mask at_source = goes_on & is_of_source, at_target = goes_on & !is_of_source;
    replace(source_, source_side_, at_source, apex, apex_side);
    replace(target_, target_side_, at_target, apex, apex_side);
    if(stops.any())
      note_stops(stops);
    const auto takes_third = at_source.values(), takes_second = at_target.values();
    int met_again = 0;
    for(int l = 0; l < number_of_lanes; ++l)
    {
      const Halfedge second = view_.preceding(third[l]);
      const Halfedge edge = takes_third[l] ? third[l] : takes_second[l] ? second : edge_[l];
      met_again += (edge == first_edge_[l]) + (edge == checkpoint_[l]);
      edge_[l] = edge;
    }
    if(met_again > 0)
      note_circles();
  }

  /// ends limbs that left the mesh, whose sections are closed, or that lost their way.
  void note_stops(const Mask& stops)
  {
    for(int l = 0; l < number_of_lanes; ++l)
      if(stops[l])
        end_[l] = !closed_[l] && view_.opposite(edge_[l]) == View::null_halfedge() ? border : degenerate;
    growing_ = growing_ & !stops;
  }

  /// Limbs that are back at the edge where they began lead to the query point, where their sections close. Those that go
  /// round in circles elsewhere end.
  void note_circles()
  {
    Values closes(0), ends(0);
    for(int l = 0; l < number_of_lanes; ++l)
    {
      if(!growing_[l])
        continue;
      if(edge_[l] == first_edge_[l])
        closes.set(l, 1);
      else if(edge_[l] == checkpoint_[l])
      {
        end_[l] = degenerate;
        ends.set(l, 1);
      }
    }
    closed_ = closed_ | (closes > Values(0));
    growing_ = growing_ & !(ends > Values(0));
    lead_to_query_point(closes > Values(0));
  }

  static Values between(const Values& from, const Values& to, const Values& share) { return from + share * (to - from); }
  static constexpr Scalar infinity() { return std::numeric_limits<Scalar>::infinity(); }

  using Lanes_of_halfedges = std::array<Halfedge, number_of_lanes>;

  const View& view_;
  const Local_coordinates<Scalar>& local_;
  Values cosine_, sine_, shift_;
  bool by_arc_length_;
  Lanes_of_halfedges edge_, first_edge_, checkpoint_; ///< on the way out of a face
  Lane_points<Scalar> source_, target_;               ///< of `edge_`
  Values source_side_, target_side_;
  Values y_, z_, length_, reached_; ///< where the limb is, along its direction and the normal, and how far it came
  Mask growing_, closed_;
  std::array<Limb_end, number_of_lanes> end_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LIMB_BUNDLE_H
