// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_NEIGHBOURHOOD_NORMALS_H
#define CGAL_SPIDER_INTERNAL_NEIGHBOURHOOD_NORMALS_H

#include <CGAL/Spider/internal/Mesh_snapshot.h>
#include <CGAL/Spider/internal/first_normal.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns what `neighbourhood_normal_at_vertex()` does, for all vertices at once: linear in the size of the mesh.
template <typename Scalar, typename Radius>
std::vector<Vec3<Scalar>> neighbourhood_normals(const Mesh_snapshot<Scalar>& mesh, const Radius& radius_at)
{
  using Vertex = typename Mesh_snapshot<Scalar>::Vertex;
  const Vertex n = static_cast<Vertex>(mesh.number_of_vertices());
  Scalar unit_length = 1; // one for all; which doesn't matter, as long as its square is neither huge nor tiny
  for(Vertex v = 0; v < n; ++v)
    if(radius_at(v) > 0 && std::isfinite(radius_at(v)))
    {
      unit_length = radius_at(v);
      break;
    }
  std::vector<Vec3<Scalar>> normals(n, nan_vec3<Scalar>()), area_vectors(n, Vec3<Scalar>::Zero());
  std::vector<int> passes(n, 0);
  int most_passes = 0;
  for(Vertex v = 0; v < n; ++v)
  {
    const Site<Mesh_snapshot<Scalar>> site = site_at_vertex(mesh, v);
    if(site.rim.empty())
      continue;
    area_vectors[v] = area_vector(mesh, site, unit_length);
    passes[v] = number_of_averaging_passes(mesh, site, radius_at(v));
    most_passes = std::max(most_passes, passes[v]);
  }

  std::vector<Vec3<Scalar>> next(n);
  for(int pass = 1; pass <= most_passes; ++pass)
  {
    for(Vertex v = 0; v < n; ++v)
    {
      next[v] = area_vectors[v];
      if(passes[v] == 0)
        continue;
      visit_corners(mesh, mesh.first_corner(v), [&](typename Mesh_snapshot<Scalar>::Halfedge corner) {
        const auto edge = mesh.other_edges(corner).first;
        next[v] += area_vectors[mesh.source(edge)] / 2 + area_vectors[mesh.target(edge)] / 2;
      });
      if(passes[v] == pass)
        normals[v] = unit(next[v]);
    }
    std::swap(area_vectors, next);
  }
  return normals;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_NEIGHBOURHOOD_NORMALS_H
