// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_ESTIMATE_H
#define CGAL_SPIDER_TOOL_ESTIMATE_H

#include "Mesh_attributes.h"
#include "Settings.h"
#include "tool_types.h"

#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// How far limbs grow from each vertex.
struct Radius
{
  std::string name;                          // a number for people, and what tells several radii's columns apart
  std::vector<double> of_vertex;             // all the same unless they are given or suggested by vertex
  std::vector<Kernel::Vector_3> elongations; // where limbs adapt by direction
};

double mean_edge_length(const Mesh& mesh);

// returns the radii that the settings ask for, one at least; std::invalid_argument as the library has it.
std::vector<Radius> choose_radii(const Mesh& mesh, const Settings& settings, const Mesh_attributes& attributes);

// estimates at all vertices with each of the radii.
std::vector<Run<Estimate>> estimate(const Mesh& mesh, const std::vector<Radius>& radii, const Settings& settings,
                                    const Mesh_attributes& attributes);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_ESTIMATE_H
