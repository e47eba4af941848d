// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_TYPES_H
#define CGAL_SPIDER_TOOL_TYPES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spider/Curvature_estimate_3.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// Reading and repairing decide by predicates, and these must be right on whatever file comes.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Estimate = Curvature_estimate_3<Kernel>;

// A property map onto an array by the numbers of vertices, edges or faces.
template <typename Key, typename Value>
struct Array_map
{
  using key_type = Key;
  using value_type = std::remove_const_t<Value>;
  using reference = Value&;
  using category = boost::lvalue_property_map_tag;

  Value* values;

  friend Value& get(const Array_map& map, Key key) { return map.values[key]; }
  friend void put(const Array_map& map, Key key, const value_type& value) { map.values[key] = value; }
};

// What one method answered, and how long it took.
template <typename Answer>
struct Run
{
  std::vector<Answer> answers; // one per vertex
  double seconds;
};

// A file can't be read or written, or what reads or writes it isn't there; what() is one line for whoever named it.
class File_error : public std::runtime_error
{
public:
  File_error(const std::string& file, const std::string& reason) : std::runtime_error(file + ": " + reason) {}
};

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_TYPES_H
