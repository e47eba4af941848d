// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The level set of a scalar on a mesh as a graph: its crossings with the edges, and which crossing follows which.

#ifndef CGAL_SPIDER_INTERNAL_LEVEL_SET_H
#define CGAL_SPIDER_INTERNAL_LEVEL_SET_H

#include <CGAL/Spider/internal/Line_builder.h>
#include <CGAL/Spider/internal/numbers.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns how far `value` is on the way from `low` to `high`, where low < value < high.
template <typename Scalar>
Scalar share_between(Scalar low, Scalar value, Scalar high)
{
  if(std::isfinite(high - low))
    return (value - low) / (high - low);
  return (value / 2 - low / 2) / (high / 2 - low / 2);
}

/*
A vertex whose scalar is `value` counts as above it. So an edge is crossed or not, and each face by none or two of its
edges: ties need no other rule, and the crossings form lines that neither branch nor break. What they draw is the
outline of the part of the surface that is above.

A crossing is named by the halfedge that leads up across it: from the vertex below to the one above. The line leaves the
face of that halfedge and enters the opposite one, so the higher side is on its left.

Where the upper end of the edge has the value itself, the crossing is at that vertex, and crossings that follow one
another may be at the same place. That is also where the part above may shrink to nothing: to a vertex, which leaves a
line of one point, or to an edge with faces below on both sides, a ridge, around which the line would run to and fro.
`next()` doesn't go along ridges, but across them, from the face on one side into that on the other, at the same vertex.
*/
template <typename View, typename TriangleMesh>
class Level_set
{
public:
  using Scalar = typename View::Scalar;
  using Vertex = typename View::Vertex;
  using Halfedge = typename View::Halfedge;
  using Location = std::pair<typename View::Face, std::array<Scalar, 3>>;

  template <typename ScalarMap>
  Level_set(const View& view, const TriangleMesh& tmesh, ScalarMap scalar_map, Scalar value)
    : view_(view), value_(value), scalars_(get(CGAL::dynamic_vertex_property_t<Scalar>(), tmesh))
  {
    for(const Vertex v : vertices(tmesh))
      put(scalars_, v, to_scalar<Scalar>(get(scalar_map, v)));
  }

  /// tells whether there is a crossing that a halfedge names.
  bool is_crossing(Halfedge h) const
  {
    const Scalar low = scalar(view_.source(h)), high = scalar(view_.target(h));
    return low < value_ && high >= value_ && std::isfinite(low) && std::isfinite(high);
  }

  /// returns the crossing that follows one on its line, or the null halfedge where the line ends.
  Halfedge next(Halfedge crossing) const
  {
    const Halfedge entry = view_.opposite(crossing);
    if(!is_in_domain(entry))
      return View::null_halfedge();
    const auto [second, third] = view_.other_edges(entry);
    if(!is_above(view_.target(second)))
      return third;
    if(!is_hit(view_.source(entry)) || !is_hit(view_.target(second)))
      return second;
    // The level set runs along the edge of `third`. It is a line only if the other side is above.
    const Halfedge across = view_.opposite(third);
    if(!is_in_domain(across))
      return View::null_halfedge();
    const auto [second_across, third_across] = view_.other_edges(across);
    return is_above(view_.target(second_across)) ? second : third_across;
  }

  Vec3<Scalar> point(Halfedge crossing) const
  {
    const Vec3<Scalar> low = view_.point(view_.source(crossing)), high = view_.point(view_.target(crossing));
    const Scalar share = share_of_high(crossing);
    return share == 1 ? high : Vec3<Scalar>(low + share * (high - low));
  }

  /// returns a crossing's place in the face that its line leaves there.
  Location location_behind(Halfedge crossing) const
  {
    return location_on_edge<Location>(view_, crossing, share_of_high(crossing));
  }

  /// returns a crossing's place in the face that its line enters there.
  Location location_ahead(Halfedge crossing) const
  {
    return location_on_edge<Location>(view_, view_.opposite(crossing), 1 - share_of_high(crossing));
  }

private:
  Scalar scalar(Vertex v) const { return get(scalars_, v); }
  bool is_above(Vertex v) const { return scalar(v) >= value_; }
  bool is_hit(Vertex v) const { return scalar(v) == value_; }

  /// tells whether there is a face at a halfedge, with a finite scalar at each corner.
  bool is_in_domain(Halfedge h) const
  {
    return h != View::null_halfedge() && std::isfinite(scalar(view_.source(h))) &&
           std::isfinite(scalar(view_.target(h))) && std::isfinite(scalar(view_.target(view_.other_edges(h).first)));
  }

  Scalar share_of_high(Halfedge crossing) const
  {
    const Scalar low = scalar(view_.source(crossing)), high = scalar(view_.target(crossing));
    return high == value_ ? Scalar(1) : share_between(low, value_, high);
  }

  View view_;
  Scalar value_;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<Scalar>>::const_type scalars_;
};

/// calls `visit(crossings, is_closed)` for each line of a level set, with its crossings in their order: first for the
/// lines that have ends.
template <typename View, typename TriangleMesh, typename Visitor>
void for_each_line(const Level_set<View, TriangleMesh>& level_set, const TriangleMesh& tmesh, Visitor&& visit)
{
  using Halfedge = typename View::Halfedge;
  enum State : char
  {
    has_no_predecessor,
    has_predecessor,
    is_done
  };
  std::vector<Halfedge> crossings;
  auto state = get(CGAL::dynamic_halfedge_property_t<char>(), tmesh);
  for(const Halfedge h : halfedges(tmesh))
    if(level_set.is_crossing(h))
    {
      crossings.push_back(h);
      put(state, h, has_no_predecessor);
    }
  for(const Halfedge crossing : crossings)
    if(const Halfedge next = level_set.next(crossing); next != View::null_halfedge())
      put(state, next, has_predecessor);

  // What isn't on a line that starts somewhere is on a closed one.
  for(const State start : {has_no_predecessor, has_predecessor})
    for(const Halfedge first : crossings)
    {
      if(get(state, first) != start)
        continue;
      std::vector<Halfedge> line;
      for(Halfedge h = first; h != View::null_halfedge() && get(state, h) != is_done; h = level_set.next(h))
      {
        line.push_back(h);
        put(state, h, is_done);
      }
      visit(line, start == has_predecessor);
    }
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LEVEL_SET_H
