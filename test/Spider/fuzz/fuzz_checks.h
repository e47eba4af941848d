// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What every answer promises, whatever the mesh and the parameters.

#ifndef CGAL_SPIDER_FUZZ_CHECKS_H
#define CGAL_SPIDER_FUZZ_CHECKS_H

#include "fuzz_meshes.h"

#include <CGAL/Spider/Curvature_estimate_3.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace fuzz {

/// A promise that wasn't kept.
struct Broken_promise : std::logic_error
{
  using std::logic_error::logic_error;
};

inline void expect(bool is_kept, const std::string& promise)
{
  if(!is_kept)
    throw Broken_promise(promise);
}

template <typename Triple>
bool all_finite(const Triple& a)
{
  return std::isfinite(a.x()) && std::isfinite(a.y()) && std::isfinite(a.z());
}

template <typename Triple>
bool is_all_nan(const Triple& a)
{
  return std::isnan(a.x()) && std::isnan(a.y()) && std::isnan(a.z());
}

/// expects a unit vector, or nothing but NaN.
inline void expect_unit_or_none(const Kernel::Vector_3& a)
{
  constexpr double rounding = 1e-12;
  expect(all_finite(a) ? std::abs(a.squared_length() - 1) <= rounding : is_all_nan(a), "a normal is unit, or NaN");
}

inline void expect_sound(const CGAL::Spider::Curvature_estimate_3<Kernel>& e)
{
  constexpr double rounding = 1e-12;
  expect(e.coverage >= 0 && e.coverage <= 1 + rounding, "coverage is in [0, 1]");
  expect_unit_or_none(e.normal);
  if(!e.is_valid())
  {
    expect(std::isnan(e.min_curvature) && std::isnan(e.max_curvature) && std::isnan(e.residual) &&
             is_all_nan(e.min_direction) && is_all_nan(e.max_direction),
           "what can't be estimated is NaN");
    return;
  }
  expect(std::isfinite(e.min_curvature) && std::isfinite(e.max_curvature), "a valid estimate has finite curvatures");
  expect(e.min_curvature <= e.max_curvature, "the smaller curvature is the smaller one");
  expect(std::isfinite(e.residual) && e.residual >= 0, "a valid estimate has a residual");
  expect(all_finite(e.normal) && all_finite(e.min_direction) && all_finite(e.max_direction),
         "a valid estimate has a frame");
  expect_unit_or_none(e.min_direction);
  expect_unit_or_none(e.max_direction);
  const auto cross = CGAL::cross_product(e.min_direction, e.max_direction);
  expect((cross - e.normal).squared_length() <= rounding * rounding, "the frame is orthogonal and right-handed");
}

} // namespace fuzz

#endif // CGAL_SPIDER_FUZZ_CHECKS_H
