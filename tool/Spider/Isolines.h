// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_ISOLINES_H
#define CGAL_SPIDER_TOOL_ISOLINES_H

#include "Settings.h"
#include "tool_types.h"

#include <CGAL/Spider/Isoline_3.h>

#include <string>
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

std::vector<Isolines> extract(const Mesh& mesh, const std::vector<Estimate>& estimates,
                              const std::vector<Isoline_request>& requests);

// tells whether write_isolines() knows the ending of a file's name.
bool is_isolines_file(const std::string& file);

// writes lines as OBJ, a group for each request, or VTP, with field and value of each line as cell data; throws
// File_error if it can't.
void write_isolines(const std::string& file, const std::vector<Isolines>& isolines);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_ISOLINES_H
