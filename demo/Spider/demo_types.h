// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_DEMO_TYPES_H
#define CGAL_SPIDER_DEMO_TYPES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace CGAL {
namespace Spider {
namespace demo {

// Reading and repairing decide by predicates, and these must be right on whatever file comes.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

} // namespace demo
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_DEMO_TYPES_H
