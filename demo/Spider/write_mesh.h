// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_DEMO_WRITE_MESH_H
#define CGAL_SPIDER_DEMO_WRITE_MESH_H

#include "demo_types.h"

#include <CGAL/Spider/Curvature_estimate_3.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace demo {

using Estimate = Curvature_estimate_3<Kernel>;

// writes the mesh as a binary PLY file: every part of the estimates, one per vertex, is a property of the vertices, and
// mean curvature is their colour, blue where the surface is concave, red where it is convex. Returns whether it could.
bool write_mesh(const std::string& file, Mesh mesh, const std::vector<Estimate>& estimates);

} // namespace demo
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_DEMO_WRITE_MESH_H
