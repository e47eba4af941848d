// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Jet_estimator.h"

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <cstdint>

namespace CGAL {
namespace Spider {
namespace tool {

void collect_connected_points(Vertex v, const Mesh& mesh, double radius, std::vector<Kernel::Point_3>& points)
{
  // Marks count searches instead of being wiped after each, which would cost more than the search.
  thread_local std::uint64_t search = 0;
  thread_local std::vector<std::uint64_t> last_search;
  thread_local std::vector<Vertex> found;

  ++search;
  if(last_search.size() < mesh.num_vertices())
    last_search.resize(mesh.num_vertices(), 0);
  found.assign(1, v);
  last_search[v] = search;
  points.assign(1, mesh.point(v));
  for(std::size_t i = 0; i < found.size(); ++i)
    for(Vertex w : CGAL::vertices_around_target(mesh.halfedge(found[i]), mesh))
    {
      if(last_search[w] == search || CGAL::squared_distance(mesh.point(v), mesh.point(w)) > radius * radius)
        continue;
      last_search[w] = search;
      found.push_back(w);
      points.push_back(mesh.point(w));
    }
}

Jet_estimator::Jet_estimator(const Mesh& mesh, const std::vector<double>& radius_of_vertex)
  : m_mesh(mesh), m_radius_of_vertex(radius_of_vertex), m_normals(mesh.num_vertices())
{
  for(Vertex v : mesh.vertices())
    m_normals[v] = CGAL::Polygon_mesh_processing::compute_vertex_normal(v, mesh);
}

Jet_estimate Jet_estimator::operator()(Vertex v) const
{
  constexpr std::size_t degree = 2;
  constexpr std::size_t number_of_coefficients = (degree + 1) * (degree + 2) / 2;

  thread_local std::vector<Kernel::Point_3> points;
  Jet_estimate estimate;
  if(m_mesh.is_isolated(v))
    return estimate;
  collect_connected_points(v, m_mesh, m_radius_of_vertex[v], points);
  if(points.size() < number_of_coefficients)
    return estimate;

  CGAL::Monge_via_jet_fitting<Kernel> fitting;
  auto monge_form = fitting(points.begin(), points.end(), degree, degree);
  monge_form.comply_wrt_given_normal(m_normals[v]);
  // Monge's form counts curvature towards the normal as positive, Spider counts it away from the normal.
  estimate.min_curvature = -monge_form.principal_curvatures(0);
  estimate.max_curvature = -monge_form.principal_curvatures(1);
  return estimate;
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
