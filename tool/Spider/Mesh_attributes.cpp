// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_attributes.h"

#include "read_mesh.h"
#include "read_numbers.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>

#include <algorithm>
#include <stdexcept>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

// A file tells an edge by the numbers of its two vertices.
void mark_edges(const std::string& file, const Mesh& mesh, std::vector<char>& is_feature)
{
  const std::vector<std::size_t> ends = read_indices(file, mesh.num_vertices());
  if(ends.size() % 2 != 0)
    throw std::invalid_argument(file + ": has an odd number of vertices: give two for each edge");
  for(std::size_t i = 0; i < ends.size(); i += 2)
  {
    const Mesh::Halfedge_index halfedge = mesh.halfedge(Vertex(ends[i]), Vertex(ends[i + 1]));
    if(halfedge == Mesh::null_halfedge())
      throw std::invalid_argument(file + ": the vertices " + std::to_string(ends[i]) + " and " +
                                  std::to_string(ends[i + 1]) + " have no edge");
    is_feature[mesh.edge(halfedge)] = true;
  }
}

} // namespace

std::size_t Mesh_attributes::number_of_features() const
{
  return std::count(is_feature.begin(), is_feature.end(), true);
}

Mesh_attributes mesh_attributes(const Mesh& mesh, const Settings& settings)
{
  Mesh_attributes attributes;
  attributes.is_feature.assign(mesh.num_edges(), false);
  if(settings.feature_angle)
    CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, *settings.feature_angle,
                                                      Array_map<Mesh::Edge_index, char>{attributes.is_feature.data()});
  if(!settings.constrained_edges.empty())
    mark_edges(settings.constrained_edges, mesh, attributes.is_feature);
  attributes.is_constrained.assign(mesh.num_vertices(), false);
  if(!settings.smoothing.constrained_vertices.empty())
    for(std::size_t v : read_indices(settings.smoothing.constrained_vertices, mesh.num_vertices()))
      attributes.is_constrained[v] = true;
  if(!settings.growth_costs.empty())
  {
    attributes.growth_costs = read_numbers(settings.growth_costs);
    check_count(settings.growth_costs, attributes.growth_costs, mesh.number_of_faces(), "triangles");
  }
  if(settings.estimation.uses_vertex_normals)
    attributes.vertex_normals = read_vertex_normals(settings.mesh, mesh);
  return attributes;
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
