// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_LIMB_RULE_H
#define CGAL_SPIDER_INTERNAL_LIMB_RULE_H

#include <CGAL/Spider/parameters.h>

namespace CGAL {
namespace Spider {
namespace internal {

/// What decides where a limb ends.
template <typename Scalar>
struct Limb_rule
{
  Limb_measure measure;
  /// of the angle between a feature edge and the cutting plane from which on the limb stops there
  Scalar sine_of_minimum_crossing_angle = Scalar(0.5);

  Limb_rule(Limb_measure by) : measure(by) {}
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LIMB_RULE_H
