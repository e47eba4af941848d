// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_RADIUS_LIST_H
#define CGAL_SPIDER_INTERNAL_RADIUS_LIST_H

#include <CGAL/Spider/internal/check_parameter.h>
#include <CGAL/Spider/internal/numbers.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// The lengths given by `geodesic_radii`, in any order.
template <typename Scalar>
struct Radius_list
{
  std::vector<Scalar> ascending;
  std::vector<std::size_t> places; ///< of the given ones among them

  Radius_list() = default;

  template <typename Range>
  explicit Radius_list(const Range& radii)
  {
    std::vector<Scalar> given;
    for(const auto& radius : radii)
    {
      given.push_back(to_scalar<Scalar>(radius));
      check_radius(given.back());
    }
    check_parameter(!given.empty(), "the number of geodesic_radii", 0, "give at least one length");
    ascending = given;
    std::sort(ascending.begin(), ascending.end());
    for(const Scalar radius : given)
      places.push_back(std::lower_bound(ascending.begin(), ascending.end(), radius) - ascending.begin());
  }
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_RADIUS_LIST_H
