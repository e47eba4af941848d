// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_SMOOTH_H
#define CGAL_SPIDER_TOOL_SMOOTH_H

#include "estimate.h"

#include <CGAL/Spider/smooth_by_geodesic_rings.h>

namespace CGAL {
namespace Spider {
namespace tool {

// smooths the mesh as the settings say, which must ask for rounds; std::invalid_argument as the library has it.
Smoothing_result<double> smooth(Mesh& mesh, const Smoothing_settings& settings, const Mesh_attributes& attributes);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_SMOOTH_H
