// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_POLYLINES_H
#define CGAL_SPIDER_TOOL_POLYLINES_H

#include "tool_types.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// A line as files hold it; the points have to outlive it.
struct Polyline
{
  std::string group; // OBJ's
  const std::vector<Kernel::Point_3>& points;
  bool is_closed; // the last point is the first one
};

// Lines and what VTP tells of each, under names: the first numbers are those to show in colour.
struct Polylines
{
  std::vector<Polyline> lines;
  std::vector<std::pair<std::string, std::vector<double>>> numbers;
  std::vector<std::pair<std::string, std::vector<unsigned char>>> codes;
  std::vector<std::string> comments;
};

// tells whether write_polylines() knows the ending of a file's name.
bool is_polylines_file(const std::string& file);

// writes lines as OBJ, those of a group behind its name, or VTP; throws File_error if it can't.
void write_polylines(const std::string& file, const Polylines& polylines);

inline double length(const std::vector<Kernel::Point_3>& points)
{
  double sum = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
  return sum;
}

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_POLYLINES_H
