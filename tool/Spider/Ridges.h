// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_RIDGES_H
#define CGAL_SPIDER_TOOL_RIDGES_H

#include "Polylines.h"
#include "Settings.h"
#include "tool_types.h"

#include <CGAL/Spider/Ridge_3.h>

#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

using Ridge = Ridge_3<Mesh>;

// returns the ridges and valleys that estimates with the radii tell; std::invalid_argument as the library has it.
std::vector<Ridge> find_ridges(const Mesh& mesh, const std::vector<Estimate>& estimates,
                               const std::vector<double>& radius_of_vertex, const Ridge_settings& settings);

// returns the lines for a file: a group for each kind, and the kind, strength and sharpness of each line.
Polylines polylines(const std::vector<Ridge>& ridges);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_RIDGES_H
