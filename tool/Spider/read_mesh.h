// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_READ_MESH_H
#define CGAL_SPIDER_TOOL_READ_MESH_H

#include "tool_types.h"

#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// what() is one line for whoever chose the file.
class Unusable_mesh : public File_error
{
public:
  using File_error::File_error;
};

// returns the mesh in an OFF, OBJ, PLY or STL file, its polygons triangulated; throws Unusable_mesh if there is none.
Mesh read_mesh(const std::string& file);

// returns the normals that a PLY or OFF file gives its points, for the vertices of the mesh that was read from it;
// Unusable_mesh if there are none.
std::vector<Kernel::Vector_3> read_vertex_normals(const std::string& file, const Mesh& mesh);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_READ_MESH_H
