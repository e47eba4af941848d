// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_LIMBS_H
#define CGAL_SPIDER_TOOL_LIMBS_H

#include "Mesh_attributes.h"
#include "Polylines.h"
#include "Settings.h"
#include "tool_types.h"

#include <CGAL/Spider/Limb_3.h>

#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// The limbs of one vertex, in angular order, and their ends as a closed line: the geodesic ring.
struct Limbs
{
  std::size_t vertex;
  std::vector<Limb_3<Mesh>> limbs;
  std::vector<Kernel::Point_3> ring;
};

// traces the limbs of the vertices that the settings name, from the estimates' normals; those without a normal have
// none. std::invalid_argument as the library has it, and for numbers that no vertex has.
std::vector<Limbs> trace_limbs(const Mesh& mesh, const std::vector<Estimate>& estimates,
                               const std::vector<double>& radius_of_vertex, const Settings& settings,
                               const Mesh_attributes& attributes);

// returns the lines for a file: groups for limbs and rings, and the length, vertex and end of each line.
Polylines polylines(const std::vector<Limbs>& spiders);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_LIMBS_H
