// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The walk of one limb (paper, 2.2): from the query point, face to face, along the cut of the mesh with a half plane.

#ifndef CGAL_SPIDER_INTERNAL_WALK_LIMB_H
#define CGAL_SPIDER_INTERNAL_WALK_LIMB_H

#include <CGAL/Spider/Limb_3.h>
#include <CGAL/Spider/internal/Cut.h>
#include <CGAL/Spider/internal/Growth_limit.h>
#include <CGAL/Spider/internal/Limb_rule.h>
#include <CGAL/Spider/internal/Site.h>
#include <CGAL/Spider/internal/numbers.h>
#include <CGAL/Spider/parameters.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace CGAL {
namespace Spider {
namespace internal {

/// One step of a walk: the polyline's next segment leads to the point of the cut at (`y`, `z`).
template <typename View>
struct Step
{
  using Scalar = typename View::Scalar;

  const Exit<View>* exit;       ///< the edge crossed at its end, none where the section closes at the query point
  Scalar crossing;              ///< where on that edge
  Scalar share;                 ///< how much of the way to that crossing is taken: less than 1 at the limb's end
  Scalar y, z;                  ///< where that leads
  Scalar from, to;              ///< what the measure says at the segment's ends, in units of the radius
};

/// How a walk ended, and at which edge if it ended early.
template <typename View>
struct Walk_result
{
  Limb_end end;
  typename View::Halfedge edge = View::null_halfedge();
  typename View::Scalar reached = 0; ///< by the limb's measure, in units of the radius
};

/// A limb that makes no headway, since it climbs a wall, is given up when it is as many radii long.
constexpr int longest_limb_in_radii = 4;

/// Follows a limb segment by segment, and cuts it where it reaches the radius by its measure.
template <typename View>
class Limb_growth
{
  using Scalar = typename View::Scalar;

public:
  explicit Limb_growth(Limb_measure measure) : measure_(measure) {}

  Scalar reached() const { return reached_; }

  /// has the following segments cost as many times their length.
  void enter_face_of(Scalar cost) { limit_.enter(cost, reached_); }

  /// takes the segment to (`y`, `z`), calls `visit(step)` and tells how the limb ends with it, if it does.
  template <typename Visitor>
  std::optional<Limb_end>
  take(const Exit<View>* exit, Scalar crossing, Scalar y, Scalar z, Visitor& visit)
  {
    const Scalar dy = y - y_, dz = z - z_, step = std::sqrt(dy * dy + dz * dz);
    if(!std::isfinite(step))
      return degenerate;
    const Scalar from = measure_ == arc_length ? reached_ : y_;
    const Scalar to = measure_ == arc_length ? reached_ + step : y;
    const Scalar limit = limit_.limit();
    const bool is_last = to >= limit;
    const Scalar share = is_last && to > from ? (limit - from) / (to - from) : Scalar(1);
    y_ += share * dy;
    z_ += share * dz;
    length_ += share * step;
    visit(Step<View>{exit, crossing, share, y_, z_, from, is_last ? limit : to});
    reached_ = is_last ? limit : std::max(reached_, to);
    if(is_last)
      return limit < 1 ? slowed : radius_reached;
    return length_ > longest_limb_in_radii ? std::make_optional(slowed) : std::nullopt;
  }

private:
  Limb_measure measure_;
  Growth_limit<Scalar> limit_;
  Scalar y_ = 0, z_ = 0, length_ = 0, reached_ = 0;
};

/// walks a limb and calls `visit(step)` for every segment of it. It stops at an edge beyond which there is no face, at
/// a feature edge that is far enough from parallel, and at a face of infinite cost. Linear in the number of faces crossed.
template <typename View, typename Visitor>
Walk_result<View> walk_limb(const View& view,
                            const Site<View>& site,
                            Cut<typename View::Scalar> cut,
                            const Limb_rule<typename View::Scalar>& rule,
                            Visitor&& visit)
{
  using Scalar = typename View::Scalar;
  Exit<View> exit = first_exit_either_way(view, site, cut);
  if(!exit.exists())
    return {site.end_at_once};

  const typename View::Halfedge first_edge = exit.edge, none = View::null_halfedge();
  Limb_growth<View> growth(rule.measure);
  typename View::Halfedge entry = none;
  while(true)
  {
    if(view.has_growth_costs())
    {
      const Scalar cost = view.growth_cost(exit.edge);
      if(!std::isfinite(cost))
        return {slowed, entry, growth.reached()};
      growth.enter_face_of(cost);
    }
    const Scalar c = exit.crossing();
    const Scalar y = exit.source.y + c * (exit.target.y - exit.source.y);
    const Scalar z = exit.source.z + c * (exit.target.z - exit.source.z);
    if(const auto end = growth.take(&exit, c, y, z, visit))
      return {*end, *end == radius_reached ? none : exit.edge, growth.reached()};

    const Exit<View> next = next_exit(view, cut, exit);
    if(!next.exists())
      return {border, exit.edge, growth.reached()};
    if(view.is_feature(exit.edge) && exit.sine_of_angle() >= rule.sine_of_minimum_crossing_angle)
      return {feature_edge, exit.edge, growth.reached()};
    if(next.edge == first_edge) // the section is closed, and the query point is where it closes
    {
      const auto end = growth.take(nullptr, Scalar(0), Scalar(0), Scalar(0), visit);
      return {end.value_or(degenerate), none, growth.reached()};
    }
    entry = exit.edge;
    exit = next;
  }
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_WALK_LIMB_H
