// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_MESH_ATTRIBUTES_H
#define CGAL_SPIDER_TOOL_MESH_ATTRIBUTES_H

#include "Settings.h"
#include "tool_types.h"

#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// What is known of a mesh beside its points and faces.
struct Mesh_attributes
{
  std::vector<char> is_feature;                 // per edge: it stops limbs
  std::vector<char> is_constrained;             // per vertex: smoothing leaves it where it is
  std::vector<double> growth_costs;             // per face; none if nothing is said of them
  std::vector<Kernel::Vector_3> vertex_normals; // to start from; none if nothing is said of them

  std::size_t number_of_features() const;
};

// finds the features and reads what else the settings ask for, std::invalid_argument as in read_numbers.h.
Mesh_attributes mesh_attributes(const Mesh& mesh, const Settings& settings);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_MESH_ATTRIBUTES_H
