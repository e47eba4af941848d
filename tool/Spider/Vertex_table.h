// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_VERTEX_TABLE_H
#define CGAL_SPIDER_TOOL_VERTEX_TABLE_H

#include "estimate.h"
#include "tool_types.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Spider/classify_vertices.h>

#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// Numbers of the vertices under a name; they are asked for when they are written, since there may be very many.
struct Column
{
  enum Kind
  {
    real,
    vector, // of three components
    code    // a small whole number
  };

  std::string name;
  Kind kind;
  std::function<double(Vertex, int component)> value;
};

// What files hold of a mesh' vertices beside their points.
struct Vertex_table
{
  std::vector<Column> columns;
  std::function<CGAL::IO::Color(Vertex)> colour;
  std::vector<std::string> comments; // for people
};

struct Labels
{
  std::vector<Vertex_label> of_vertex;
  double threshold;
};

// returns all parts of the estimates, labels (one for each radius, or none) and the colour. If there are several radii,
// their columns end in _r and the radius. The runs, radii and labels have to outlive the table.
Vertex_table make_table(const std::vector<Run<Estimate>>& runs, const std::vector<Radius>& radii,
                        const std::vector<Labels>& labels, const std::string& colour_by);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_VERTEX_TABLE_H
