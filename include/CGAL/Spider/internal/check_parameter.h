// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_CHECK_PARAMETER_H
#define CGAL_SPIDER_INTERNAL_CHECK_PARAMETER_H

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace CGAL {
namespace Spider {
namespace internal {

/// throws unless a parameter's value is one that its remedy asks for.
template <typename Value>
void check_parameter(bool is_valid, const char* name, const Value& value, const char* remedy)
{
  if(is_valid)
    return;
  std::ostringstream message;
  message << "Spider: " << name << " is " << value << ": " << remedy;
  throw std::invalid_argument(message.str());
}

template <typename Scalar>
void check_radius(Scalar radius)
{
  check_parameter(radius > 0 && std::isfinite(radius), "geodesic_radius", radius,
                  "give a positive, finite length in the mesh's units, for example 4 mean edge lengths");
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_CHECK_PARAMETER_H
