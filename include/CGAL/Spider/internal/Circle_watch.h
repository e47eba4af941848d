// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_CIRCLE_WATCH_H
#define CGAL_SPIDER_INTERNAL_CIRCLE_WATCH_H

#include <CGAL/Spider/internal/Lane_edges.h>

#include <cstddef>

namespace CGAL {
namespace Spider {
namespace internal {

/// Tells where limbs in lockstep come back to: to the edge where they began, or, in a circle, to one that they passed.
/// As such it remembers the edges of steps 1, 2, 4, 8 and so on, each until the next (Brent).
template <typename View>
class Circle_watch
{
public:
  using Edges = Lane_edges<View>;
  using Mask = Lane_mask<typename View::Scalar>;

  explicit Circle_watch(const Edges& first) : first_(first), passed_(first) {}

  /// notes that a step is done.
  void note_step(const Edges& edges)
  {
    if(++steps_ != next_to_remember_)
      return;
    passed_ = edges;
    next_to_remember_ *= 2;
  }

  Mask are_first(const Edges& edges) const { return edges == first_; }
  Mask are_passed(const Edges& edges) const { return edges == passed_; }

private:
  Edges first_, passed_;
  std::size_t steps_ = 0, next_to_remember_ = 1;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_CIRCLE_WATCH_H
