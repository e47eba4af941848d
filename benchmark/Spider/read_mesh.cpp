// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <stdexcept>

namespace CGAL {
namespace Spider {
namespace benchmark {

Mesh read_mesh(const std::string& path)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(path, mesh) || mesh.is_empty())
    throw std::runtime_error("cannot read a mesh from " + path);
  PMP::triangulate_faces(mesh);
  mesh.collect_garbage();
  return mesh;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
