// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_CORRECTED_CURVATURES_H
#define CGAL_SPIDER_BENCHMARK_CORRECTED_CURVATURES_H

#include "../Estimator.h"

#include <CGAL/Spider/internal/cgal_compat.h>

#ifdef CGAL_SPIDER_HAS_CORRECTED_CURVATURES

#include "shared/vertex_normals.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>

#include <algorithm>

namespace CGAL {
namespace Spider {
namespace benchmark {

// Lachaud, Romon, Thibert and Coeurjolly, "Interpolated corrected curvature measures for polygonal surfaces", 2020,
// through CGAL's own implementation, `PMP::interpolated_corrected_curvatures` (CGAL 6.0 and later): nothing of the
// method is written here, and its curvatures have the sign that is wanted. The normals that CGAL would take by itself,
// those of `PMP::compute_vertex_normals`, seek the most visible direction rather than an average; area-weighted ones,
// given as CGAL lets one, take up to half of the ball's error away on irregular meshes, and so are its best case.
// Whichever they are, they are computed within the time.
class Corrected_curvatures : public Estimator
{
public:
  enum class Neighbourhood
  {
    one_ring, // CGAL's default: the measures of the vertex's faces
    ball      // the measures of the faces in a ball, by their share in it
  };

  enum class Normals
  {
    own, // CGAL's default
    area // averaged by area
  };

  Corrected_curvatures(Neighbourhood neighbourhood, Normals normals)
    : m_neighbourhood(neighbourhood), m_normals(normals)
  {}

  std::string name() const override
  {
    return (uses_radius() ? "icc_ball" : "icc") + std::string(m_normals == Normals::own ? "" : "_area");
  }

  std::string settings() const override
  {
    return std::string("CGAL::Polygon_mesh_processing::interpolated_corrected_curvatures, ") +
           (uses_radius() ? "ball_radius r" : "one-ring (default)") +
           (m_normals == Normals::own ? ", CGAL's own vertex normals" : ", area-weighted vertex normals");
  }

  bool uses_radius() const override { return m_neighbourhood == Neighbourhood::ball; }

  void estimate(const Mesh& mesh, double radius, std::vector<Estimate>& out) const override
  {
    out.assign(mesh.num_vertices(), Estimate());
    if(mesh.number_of_faces() == 0)
      return;
    // CGAL's function takes every vertex to have a face
    const auto is_isolated = [&](Mesh::Vertex_index v) { return mesh.is_isolated(v); };
    if(std::none_of(mesh.vertices().begin(), mesh.vertices().end(), is_isolated))
      return estimate_all(mesh, radius, out);
    Mesh without_isolated(mesh);
    for(Mesh::Vertex_index v : mesh.vertices())
      if(is_isolated(v))
        without_isolated.remove_vertex(v); // the others keep their indices
    estimate_all(without_isolated, radius, out);
  }

private:
  using Principal = CGAL::Polygon_mesh_processing::Principal_curvatures_and_directions<Kernel>;

  void estimate_all(const Mesh& mesh, double radius, std::vector<Estimate>& out) const
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    constexpr double one_ring_radius = -1; // CGAL's own way to say so
    const auto normals = get(CGAL::dynamic_vertex_property_t<Vector>(), mesh);
    const auto principal = get(CGAL::dynamic_vertex_property_t<Principal>(), mesh);
    if(m_normals == Normals::own)
      PMP::compute_vertex_normals(mesh, normals);
    else
    {
      const std::vector<Vector> by_area = vertex_normals(mesh, Normal_weight::area);
      for(Mesh::Vertex_index v : mesh.vertices())
        put(normals, v, by_area[v.idx()]);
    }
    PMP::interpolated_corrected_curvatures(mesh, CGAL::parameters::vertex_normal_map(normals)
                                                   .vertex_principal_curvatures_and_directions_map(principal)
                                                   .ball_radius(uses_radius() ? radius : one_ring_radius));
    for(Mesh::Vertex_index v : mesh.vertices())
      out[v.idx()] = estimate_of(get(principal, v), get(normals, v));
  }

  // CGAL says zero, directions included, where there is no area to divide by
  static Estimate estimate_of(const Principal& principal, const Vector& normal)
  {
    Estimate estimate;
    if(!(normal.squared_length() > 0))
      return estimate;
    estimate.normal = normal;
    if(!std::isfinite(principal.min_curvature) || !std::isfinite(principal.max_curvature) ||
       !(principal.max_direction.squared_length() > 0))
      return estimate;
    estimate.min_curvature = principal.min_curvature;
    estimate.max_curvature = principal.max_curvature;
    estimate.min_direction = principal.min_direction;
    estimate.max_direction = principal.max_direction;
    return estimate;
  }

  Neighbourhood m_neighbourhood;
  Normals m_normals;
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_HAS_CORRECTED_CURVATURES

#endif // CGAL_SPIDER_BENCHMARK_CORRECTED_CURVATURES_H
