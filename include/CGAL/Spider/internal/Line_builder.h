// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_LINE_BUILDER_H
#define CGAL_SPIDER_INTERNAL_LINE_BUILDER_H

#include <CGAL/Spider/internal/numbers.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns a point of a halfedge in its face, in the order of corners that `PMP::Face_location` has.
template <typename Location, typename View>
Location location_on_edge(const View& view, typename View::Halfedge h, typename View::Scalar share_of_target)
{
  const auto f = view.face(h);
  const typename View::Halfedge first = view.halfedge(f);
  const std::size_t source = h == first ? 0 : view.preceding(h) == first ? 1 : 2;
  Location result{f, {}};
  result.second[source] = 1 - share_of_target;
  result.second[(source + 1) % 3] = share_of_target;
  return result;
}

/// Gathers the crossings of one line with edges into points: crossings that follow one another at the same place are
/// one point. A crossing is named by the halfedge of the face that the line leaves there, for the opposite face;
/// `Crossings` knows where on the edges they are.
template <typename Crossings, typename Line>
class Line_builder
{
  using Halfedge = typename Crossings::Halfedge;
  using FT = typename Line::FT;
  using Point_3 = typename Line::Point_3;

  struct Node
  {
    Point_3 point;
    Halfedge first, last; ///< of the crossings that are at this point
  };

public:
  Line_builder(const Crossings& places, const std::vector<Halfedge>& crossings, bool is_closed)
    : crossings_(places), is_closed_(is_closed)
  {
    for(const Halfedge crossing : crossings)
    {
      const Point_3 point = from_vec3<Point_3>(places.point(crossing));
      if(!nodes_.empty() && nodes_.back().point == point)
        nodes_.back().last = crossing;
      else
        nodes_.push_back({point, crossing, crossing});
    }
    if(is_closed)
      close();
  }

  /// tells whether there is a line: not just a point, nor a segment and the way back.
  bool is_line() const { return nodes_.size() >= (is_closed_ ? 4 : 2); }

  Line line() const
  {
    Line result;
    result.is_closed = is_closed_;
    for(const Node& node : nodes_)
    {
      const bool is_end = &node == &nodes_.back();
      const auto [f, weights] = is_end ? crossings_.location_behind(node.first) : crossings_.location_ahead(node.last);
      result.points.push_back(node.point);
      result.locations.push_back(
        {f, {static_cast<FT>(weights[0]), static_cast<FT>(weights[1]), static_cast<FT>(weights[2])}});
    }
    return result;
  }

private:
  /// joins the end to the start, which is repeated.
  void close()
  {
    if(nodes_.size() > 1 && nodes_.back().point == nodes_.front().point)
    {
      nodes_.front().first = nodes_.back().first;
      nodes_.pop_back();
    }
    nodes_.push_back(Node(nodes_.front()));
  }

  const Crossings& crossings_;
  bool is_closed_;
  std::vector<Node> nodes_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LINE_BUILDER_H
