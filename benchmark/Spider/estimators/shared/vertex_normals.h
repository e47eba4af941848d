// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_SHARED_VERTEX_NORMALS_H
#define CGAL_SPIDER_BENCHMARK_SHARED_VERTEX_NORMALS_H

#include "Face_geometry.h"

namespace CGAL {
namespace Spider {
namespace benchmark {

// How a vertex normal is averaged from the normals of its faces. The papers say which average they want; the normals
// of `PMP::compute_vertex_normals` are none (they seek the most visible direction), and cost more to find than most
// one-ring estimators take in all.
enum class Normal_weight
{
  // Taubin 1995: the face's area
  area,
  // Max 1999, "Weights for computing vertex normals from facet normals": the sine of the corner's angle over the
  // product of the adjacent lengths, exact wherever the vertex and its neighbours lie on a sphere
  sphere
};

// a unit vector, or NaN where `v` has no direction
inline Vector normalized(const Vector& v)
{
  const double length = std::sqrt(v.squared_length());
  return length > 0 ? v / length : Vector(Estimate::nan, Estimate::nan, Estimate::nan);
}

inline bool is_finite(const Vector& v) { return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()); }

// Unit normals by vertex index; NaN at a vertex that has no face with an area.
inline std::vector<Vector> vertex_normals(const Mesh& mesh, Normal_weight weight)
{
  std::vector<Vector> normals(mesh.num_vertices(), Vector(0, 0, 0));
  for(Mesh::Face_index face : mesh.faces())
  {
    const Face_geometry geometry(mesh, face);
    for(int i = 0; i < 3; ++i)
    {
      const double adjacent = geometry.squared_lengths[next_corner(i)] * geometry.squared_lengths[previous_corner(i)];
      if(weight == Normal_weight::area)
        normals[geometry.vertices[i].idx()] += geometry.doubled_area_vector;
      else if(adjacent > 0)
        normals[geometry.vertices[i].idx()] += geometry.doubled_area_vector / adjacent;
    }
  }
  for(Vector& normal : normals)
    normal = normalized(normal);
  return normals;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_SHARED_VERTEX_NORMALS_H
