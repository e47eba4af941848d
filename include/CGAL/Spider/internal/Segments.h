// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SEGMENTS_H
#define CGAL_SPIDER_INTERNAL_SEGMENTS_H

#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/Local_coordinates.h>

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
  Lanes<Scalar> start, exit;                 ///< how far along it the way starts, and where it ends at the crossing
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SEGMENTS_H
