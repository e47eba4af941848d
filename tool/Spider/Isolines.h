// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_ISOLINES_H
#define CGAL_SPIDER_TOOL_ISOLINES_H

#include "Polylines.h"
#include "Settings.h"
#include "tool_types.h"

#include <CGAL/Spider/Isoline_3.h>

#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// The lines along which one field has one value.
struct Isolines
{
  Isoline_request request;
  std::vector<Isoline_3<Mesh>> lines;

  double length() const;
};

std::vector<Isolines> find_isolines(const Mesh& mesh, const std::vector<Estimate>& estimates,
                                    const std::vector<Isoline_request>& requests);

// returns the lines for a file: a group for each request, and the value and the request's number of each line.
Polylines polylines(const std::vector<Isolines>& isolines);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_ISOLINES_H
