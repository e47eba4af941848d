// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The cut of a mesh with the half plane of one limb (paper, 2.2), edge by edge.
//
// One rule decides every degenerate case. The side of the cutting plane on which a vertex lies is a function of the
// vertex alone, and a vertex on the plane counts as left. So a face is either not cut or cut through exactly two of its
// edges, whatever its shape: the walk never has a choice, never meets an edge twice in the same direction before it is
// back where it started, and so always ends. The rule is put into effect by moving the plane to the right by an amount
// at the level of rounding; where no face of the star is found that way, since the star lies on the left of a plane
// along its border, by moving it to the left.

#ifndef CGAL_SPIDER_INTERNAL_CUT_H
#define CGAL_SPIDER_INTERNAL_CUT_H

#include <CGAL/Spider/internal/Local_coordinates.h>
#include <CGAL/Spider/internal/Site.h>
#include <CGAL/Spider/internal/numbers.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Spider {
namespace internal {

/// A point in the frame of a cut: `y` along the limb's direction, `z` along the normal, `side` across the plane.
template <typename Scalar>
struct Cut_point
{
  Scalar y, z, side;
};

/// The half plane of one limb: through the normal, and the direction at the angle given by its cosine and sine.
template <typename Scalar>
class Cut
{
public:
  Cut(const Local_coordinates<Scalar>& local, Scalar cosine, Scalar sine)
    : local_(local), cosine_(cosine), sine_(sine), shift_(local.rounding())
  {
  }

  /// returns the distance at which points are the same but for rounding.
  Scalar rounding() const { return local_.rounding(); }
  /// returns how far to the right of the query point the plane runs.
  Scalar shift() const { return shift_; }

  /// has vertices on the plane count as right instead of left.
  void count_vertices_on_the_plane_as_right() { shift_ = -local_.rounding(); }

  Cut_point<Scalar> operator()(const Vec3<Scalar>& point) const
  {
    const Vec3<Scalar> a = local_(point);
    return {cosine_ * a.x() + sine_ * a.y(), a.z(), cosine_ * a.y() - sine_ * a.x() + shift_};
  }

private:
  Local_coordinates<Scalar> local_;
  Scalar cosine_, sine_, shift_;
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
  /// returns the sine of the angle between the edge and the plane.
  Scalar sine_of_angle() const
  {
    const Scalar across = target.side - source.side;
    return std::abs(across) / std::hypot(target.y - source.y, target.z - source.z, across);
  }
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

/// finds that edge; where there is none with vertices on the plane counted as left, counts them as right from then on.
template <typename View>
Exit<View> first_exit_either_way(const View& view, const Site<View>& site, Cut<typename View::Scalar>& cut)
{
  const Exit<View> exit = first_exit(view, site, cut);
  if(exit.exists())
    return exit;
  cut.count_vertices_on_the_plane_as_right();
  return first_exit(view, site, cut);
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_CUT_H
