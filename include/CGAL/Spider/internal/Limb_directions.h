// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_LIMB_DIRECTIONS_H
#define CGAL_SPIDER_INTERNAL_LIMB_DIRECTIONS_H

#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/Spider_frame.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// The directions of all limbs of a spider, a bundle at a time.
template <typename Scalar>
struct Limb_directions
{
  int number_of_limbs = 0;
  std::vector<Lanes<Scalar>> cosines, sines;

  void set(int number_of_directions)
  {
    if(number_of_limbs == 2 * number_of_directions)
      return;
    number_of_limbs = 2 * number_of_directions;
    cosines.assign((number_of_limbs + number_of_lanes - 1) / number_of_lanes, Lanes<Scalar>(1));
    sines.assign(cosines.size(), Lanes<Scalar>(0));
    for(int i = 0; i < number_of_limbs; ++i)
    {
      const Scalar angle = angle_of_direction<Scalar>(i, number_of_directions);
      cosines[i / number_of_lanes].set(i % number_of_lanes, std::cos(angle));
      sines[i / number_of_lanes].set(i % number_of_lanes, std::sin(angle));
    }
  }

  /// returns how many of a bundle's lanes are limbs.
  int limbs_in_bundle(std::size_t bundle) const
  {
    return std::min(number_of_limbs - static_cast<int>(bundle) * number_of_lanes, number_of_lanes);
  }
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LIMB_DIRECTIONS_H
