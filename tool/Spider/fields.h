// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_FIELDS_H
#define CGAL_SPIDER_TOOL_FIELDS_H

#include "tool_types.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// A scalar of an estimate, under the name that files and options have for it.
struct Field
{
  const char* name;
  double (*of)(const Estimate&);
  bool is_diverging; // zero is a middle of its own
};

inline constexpr std::array<Field, 8> fields = {
  {{"k_min", [](const Estimate& e) { return e.min_curvature; }, true},
   {"k_max", [](const Estimate& e) { return e.max_curvature; }, true},
   {"H", [](const Estimate& e) { return e.mean_curvature(); }, true},
   {"K", [](const Estimate& e) { return e.Gaussian_curvature(); }, true},
   {"shape_index", [](const Estimate& e) { return e.shape_index(); }, true},
   {"curvedness", [](const Estimate& e) { return e.curvedness(); }, false},
   {"coverage", [](const Estimate& e) { return e.coverage; }, false},
   {"residual", [](const Estimate& e) { return e.residual; }, false}}};

inline std::vector<std::string> field_names()
{
  std::vector<std::string> names;
  for(const Field& field : fields)
    names.push_back(field.name);
  return names;
}

// returns the field of a name, which must be one of field_names().
inline const Field& field_of(const std::string& name)
{
  return *std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.name == name; });
}

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_FIELDS_H
