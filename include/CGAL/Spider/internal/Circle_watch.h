// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_CIRCLE_WATCH_H
#define CGAL_SPIDER_INTERNAL_CIRCLE_WATCH_H

#include <CGAL/Spider/internal/Lanes.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spider {
namespace internal {

/// Tells where limbs in lockstep come back to: to the edge where they began, or, in a circle, to one that they passed. As
/// such it remembers the edges of steps 1, 2, 4, 8 and so on, each until the next (Brent).
template <typename Halfedge>
class Circle_watch
{
public:
  using Edges = std::array<Halfedge, number_of_lanes>;

  explicit Circle_watch(const Edges& first) : first_(first), passed_(first) {}

  /// notes that a step is done.
  void note_step(const Edges& edges)
  {
    if(++steps_ != next_to_remember_)
      return;
    passed_ = edges;
    next_to_remember_ *= 2;
  }

  bool is_first(int lane, Halfedge edge) const { return edge == first_[lane]; }
  bool is_passed(int lane, Halfedge edge) const { return edge == passed_[lane]; }

  /// tells whether any limb that has moved on came back.
  bool any(const Edges& edges, const Edges& before) const
  {
    bool any = false;
    for(int l = 0; l < number_of_lanes; ++l)
      any |= (edges[l] != before[l]) & ((edges[l] == first_[l]) | (edges[l] == passed_[l]));
    return any;
  }

private:
  Edges first_, passed_;
  std::size_t steps_ = 0, next_to_remember_ = 1;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_CIRCLE_WATCH_H
