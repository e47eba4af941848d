// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The walk of one limb (paper, 2.2): from the query point, face to face, along the cut of the mesh with a half plane.
//
// One rule decides every degenerate case. The side of the cutting plane on which a vertex lies is a function of the
// vertex alone, and a vertex on the plane counts as left. So a face is either not cut or cut through exactly two of its
// edges, whatever its shape: the walk never has a choice, never meets an edge twice in the same direction before it is
// back where it started, and so always ends. The rule is put into effect by moving the plane to the right by an amount
// at the level of rounding; where no face of the star is found that way, since the star lies on the left of a plane
// along its border, by moving it to the left.

#ifndef CGAL_SPIDER_INTERNAL_WALK_LIMB_H
#define CGAL_SPIDER_INTERNAL_WALK_LIMB_H

#include <CGAL/Spider/Limb_3.h>
#include <CGAL/Spider/internal/Site.h>
#include <CGAL/Spider/internal/numbers.h>
#include <CGAL/Spider/parameters.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace CGAL {
namespace Spider {
namespace internal {

/// A point in the frame of a cut: `y` along the limb's direction, `z` along the normal, `side` across the plane.
template <typename Scalar>
struct Cut_point
{
  Scalar y, z, side;
};

/// The half plane of one limb. Lengths are in units of the geodesic radius, so nothing over- or underflows.
template <typename Scalar>
class Cut
{
public:
  /// `direction` and `normal` are orthonormal.
  Cut(const Vec3<Scalar>& origin, const Vec3<Scalar>& direction, const Vec3<Scalar>& normal, Scalar radius)
    : origin_(origin), along_(direction / radius), up_(normal / radius), across_(normal.cross(direction) / radius)
  {
    // The error of a coordinate is half an epsilon of its size, and a handful of operations follow.
    constexpr Scalar epsilons = 16;
    rounding_ =
      epsilons * std::numeric_limits<Scalar>::epsilon() * (1 + origin.template lpNorm<Eigen::Infinity>() / radius);
    shift_ = rounding_;
  }

  /// returns the distance at which points are the same but for rounding.
  Scalar rounding() const { return rounding_; }

  /// has vertices on the plane count as right instead of left.
  void count_vertices_on_the_plane_as_right() { shift_ = -rounding_; }

  Cut_point<Scalar> operator()(const Vec3<Scalar>& point) const
  {
    const Vec3<Scalar> a = point - origin_;
    return {a.dot(along_), a.dot(up_), a.dot(across_) + shift_};
  }

private:
  Vec3<Scalar> origin_, along_, up_, across_;
  Scalar rounding_, shift_;
};

/// An edge on its way out of a face, with its end points. The source keeps to one side of the plane along the whole walk.
template <typename View>
struct Exit
{
  using Scalar = typename View::Scalar;

  typename View::Halfedge edge = View::null_halfedge();
  Cut_point<Scalar> source{}, target{};

  bool exists() const { return edge != View::null_halfedge(); }
  /// returns where the plane crosses, from 0 at the source to 1 at the target.
  Scalar crossing() const { return source.side / (source.side - target.side); }
};

template <typename Scalar>
bool is_left(const Cut_point<Scalar>& a)
{
  return a.side >= 0;
}

/// crosses an edge into the next face and finds the edge by which the plane leaves that; none at a border.
template <typename View>
Exit<View> next_exit(const View& view, const Cut<typename View::Scalar>& cut, const Exit<View>& exit)
{
  const typename View::Halfedge entry = view.opposite(exit.edge);
  if(entry == View::null_halfedge())
    return {};
  const auto [from_source, to_target] = view.other_edges(entry);
  const auto apex = cut(view.point(view.target(from_source)));
  if(is_left(apex) == is_left(exit.source))
    return {to_target, apex, exit.target};
  return {from_source, exit.source, apex};
}

/// follows the cut beyond an exit up to where it tells ahead from behind, and tells which it is.
template <typename View>
bool leads_ahead(const View& view, const Cut<typename View::Scalar>& cut, Exit<View> exit)
{
  // Far above rounding, which a cut at a small angle to an edge magnifies, and far below the length of edges.
  constexpr typename View::Scalar same_place = 1e-9;
  const typename View::Halfedge first_edge = exit.edge;
  do
  {
    const auto y = exit.source.y + exit.crossing() * (exit.target.y - exit.source.y);
    if(!(std::abs(y) <= same_place))
      return y > 0;
    exit = next_exit(view, cut, exit);
  } while(exit.exists() && exit.edge != first_edge);
  return false;
}

/// finds the edge by which the half plane leaves the faces around the query point. Where a folded star offers several,
/// the one that rises or falls least from the direction is taken.
template <typename View>
Exit<View> first_exit(const View& view, const Site<View>& site, const Cut<typename View::Scalar>& cut)
{
  using Scalar = typename View::Scalar;
  Exit<View> best;
  Scalar least_slope = std::numeric_limits<Scalar>::infinity();
  for(typename View::Halfedge edge : site.rim)
  {
    const Cut_point<Scalar> s = cut(view.point(view.source(edge))), t = cut(view.point(view.target(edge)));
    if(is_left(s) == is_left(t))
      continue;
    // Seen with its orientation up, a face is left from right to left; folded over, from left to right. A face that is
    // seen as a line, without area or upright, doesn't tell.
    const Cut_point<Scalar> apex = cut(view.point(view.target(view.other_edges(edge).first)));
    const Scalar turn = (t.y - s.y) * (apex.side - s.side) - (t.side - s.side) * (apex.y - s.y);
    const Scalar size = std::abs(t.y - s.y) + std::abs(t.side - s.side);
    const bool is_line = std::abs(turn) <= cut.rounding() * size;
    const Exit<View> exit{edge, s, t};
    if(is_line ? !leads_ahead(view, cut, exit) : (turn > 0) != is_left(t))
      continue;
    const Scalar c = exit.crossing();
    const Scalar slope = std::abs(std::atan2(s.z + c * (t.z - s.z), s.y + c * (t.y - s.y)));
    if(slope < least_slope)
    {
      least_slope = slope;
      best = exit;
    }
  }
  return best;
}

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
    const bool is_last = to >= 1;
    const Scalar share = is_last && to > from ? (1 - from) / (to - from) : Scalar(1);
    y_ += share * dy;
    z_ += share * dz;
    length_ += share * step;
    visit(Step<View>{exit, crossing, share, y_, z_, from, is_last ? Scalar(1) : to});
    reached_ = is_last ? Scalar(1) : std::max(reached_, to);
    if(is_last)
      return radius_reached;
    return length_ > longest_limb_in_radii ? std::make_optional(slowed) : std::nullopt;
  }

private:
  Limb_measure measure_;
  Scalar y_ = 0, z_ = 0, length_ = 0, reached_ = 0;
};

/// walks a limb and calls `visit(step)` for every segment of it. Linear in the number of faces crossed.
template <typename View, typename Visitor>
Walk_result<View> walk_limb(const View& view,
                            const Site<View>& site,
                            Cut<typename View::Scalar> cut,
                            Limb_measure measure,
                            Visitor&& visit)
{
  using Scalar = typename View::Scalar;
  Exit<View> exit = first_exit(view, site, cut);
  if(!exit.exists())
  {
    cut.count_vertices_on_the_plane_as_right();
    exit = first_exit(view, site, cut);
  }
  if(!exit.exists())
    return {site.on_border ? border : degenerate};

  const typename View::Halfedge first_edge = exit.edge, none = View::null_halfedge();
  Limb_growth<View> growth(measure);
  while(true)
  {
    const Scalar c = exit.crossing();
    const Scalar y = exit.source.y + c * (exit.target.y - exit.source.y);
    const Scalar z = exit.source.z + c * (exit.target.z - exit.source.z);
    if(const auto end = growth.take(&exit, c, y, z, visit))
      return {*end, *end == radius_reached ? none : exit.edge, growth.reached()};

    const Exit<View> next = next_exit(view, cut, exit);
    if(!next.exists())
      return {border, exit.edge, growth.reached()};
    if(next.edge == first_edge) // the section is closed, and the query point is where it closes
    {
      const auto end = growth.take(nullptr, Scalar(0), Scalar(0), Scalar(0), visit);
      return {end.value_or(degenerate), none, growth.reached()};
    }
    exit = next;
  }
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_WALK_LIMB_H
