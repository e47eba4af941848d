// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_LANE_EXITS_H
#define CGAL_SPIDER_INTERNAL_LANE_EXITS_H

#include <CGAL/Spider/internal/Cut.h>
#include <CGAL/Spider/internal/Lane_edges.h>
#include <CGAL/Spider/internal/Star.h>

namespace CGAL {
namespace Spider {
namespace internal {

/// The cuts of the limbs that go in lockstep, as `Cut` is that of one, and the edges on their way out of faces.
template <typename View>
struct Lane_exits
{
  using Scalar = typename View::Scalar;
  using Edges = Lane_edges<View>;
  using Beyond = Lane_beyond<View>;
  using Values = Lanes<Scalar>;
  using Mask = Lane_mask<Scalar>;

  Values cosine, sine, shift;
  Edges edge;
  Beyond beyond;
  Lane_points<Scalar> source, target; ///< the ends of the edges
  Values source_side, target_side;

  /// finds the edges by which limbs in the directions of the given cosines and sines leave the star: among those that
  /// its rim offers, as `first_exit()` does, where there is one and no doubt of it.
  Lane_exits(const View& view, const Site<View>& site, const Star<View>& star, const Values& cosines,
             const Values& sines)
    : cosine(cosines), sine(sines), shift(star.local.rounding()), edge(site.rim.front()), source(query_point()),
      target(query_point()), source_side(1), target_side(0)
  {
    Mask offered = Values(0) > Values(1), doubtful = offered;
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
      doubtful = doubtful | (offered & ahead) | (crosses & !(absolute(turn) > Values(star.local.rounding()) * size));
      offered = offered | ahead;
      replace_source(ahead, {sx, sy, Values(e.source.z())}, s_side);
      replace_target(ahead, {tx, ty, Values(e.target.z())}, t_side);
      edge = select(ahead, Edges(e.edge), edge);
    }
    doubtful = doubtful | !offered;
    if(doubtful.any())
      for(int l = 0; l < number_of_lanes; ++l)
        if(doubtful[l])
          find_alone(l, view, site, star.local);
    if constexpr(Beyond::is_read_ahead)
      beyond = edge.beyond(view);
  }

  Values side(const Values& x, const Values& y) const { return cosine * y - sine * x + shift; }
  Values along(const Values& x, const Values& y) const { return cosine * x + sine * y; }

  void replace_source(const Mask& where, const Lane_points<Scalar>& point, const Values& side)
  {
    source = select(where, point, source);
    source_side = select(where, side, source_side);
  }

  void replace_target(const Mask& where, const Lane_points<Scalar>& point, const Values& side)
  {
    target = select(where, point, target);
    target_side = select(where, side, target_side);
  }

  /// tells where ends of edges aren't so far that squares of what is made of coordinates would overflow.
  static Mask is_near(const Lane_points<Scalar>& a)
  {
    constexpr Scalar farthest = Scalar(1e30);
    return absolute(a.x) + absolute(a.y) + absolute(a.z) < Values(farthest);
  }

  /// The faces across the edges: their apexes, and the two edges of each by which a limb may leave it.
  struct Across
  {
    Lane_points<Scalar> apex;
    Values apex_side;
    Edges from_apex, to_apex;
    Beyond beyond_from_apex, beyond_to_apex;
  };

  /// looks across the edges, where limbs will go or not. What is to be read takes a while to come, and there may be
  /// other things to do meanwhile. Hence what lies beyond the next edges may be read before it is known which limb
  /// takes which.
  Across look_across(const View& view, const Local_coordinates<Scalar>& local)
  {
    if constexpr(!Beyond::is_read_ahead)
      beyond = edge.beyond(view);
    Across across;
    across.from_apex = edge.thirds(beyond);
    across.to_apex = across.from_apex.preceding(view);
    if constexpr(Beyond::is_read_ahead)
    {
      across.beyond_from_apex = across.from_apex.beyond(view);
      across.beyond_to_apex = across.to_apex.beyond(view);
    }
    across.apex = local(beyond.apexes(view));
    across.apex_side = side(across.apex.x, across.apex.y);
    return across;
  }

  /// crosses edges into the next faces and finds the edges by which the planes leave those, for limbs that go and may
  /// go on there. Returns which these are.
  Mask cross(const Across& across, const Mask& going)
  {
    const Values zero(0);
    const Mask goes_on = going & beyond.is_open() & is_near(across.apex);
    const Mask is_of_source = (source_side >= zero) == (across.apex_side >= zero);
    const Mask at_source = goes_on & is_of_source, at_target = goes_on & !is_of_source;
    replace_source(at_source, across.apex, across.apex_side);
    replace_target(at_target, across.apex, across.apex_side);
    edge = select(at_source, across.from_apex, select(at_target, across.to_apex, edge));
    if constexpr(Beyond::is_read_ahead)
      beyond = select(at_source, across.beyond_from_apex, select(at_target, across.beyond_to_apex, beyond));
    return goes_on;
  }

  /// has limbs lead back to the query point.
  void lead_to_query_point(const Mask& which)
  {
    replace_source(which, query_point(), Values(1));
    replace_target(which, query_point(), Values(0));
  }

private:
  static Lane_points<Scalar> query_point() { return {Values(0), Values(0), Values(0)}; }

  /// A limb for which there is no edge has a source at no place.
  void find_alone(int l, const View& view, const Site<View>& site, const Local_coordinates<Scalar>& local)
  {
    Cut<Scalar> cut(local, cosine[l], sine[l]);
    const Exit<View> exit = first_exit_either_way(view, site, cut);
    shift.set(l, cut.shift());
    if(!exit.exists())
    {
      source.set(l, nan_vec3<Scalar>());
      return;
    }
    edge.set(l, exit.edge);
    source.set(l, local(view.point(view.source(exit.edge))));
    target.set(l, local(view.point(view.target(exit.edge))));
    source_side.set(l, exit.source.side);
    target_side.set(l, exit.target.side);
  }
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LANE_EXITS_H
