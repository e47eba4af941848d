// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_DEMO_READ_MESH_H
#define CGAL_SPIDER_DEMO_READ_MESH_H

#include "demo_types.h"

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Spider {
namespace demo {

// what() is one line for whoever chose the file.
class Unusable_mesh : public std::runtime_error
{
public:
  Unusable_mesh(const std::string& file, const std::string& reason) : std::runtime_error(file + ": " + reason) {}
};

// returns the mesh in an OFF, OBJ, PLY or STL file, its polygons triangulated; throws Unusable_mesh if there is none.
Mesh read_mesh(const std::string& file);

} // namespace demo
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_DEMO_READ_MESH_H
