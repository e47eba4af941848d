// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A radius for each vertex, where the density of vertices varies over the mesh.

#ifndef CGAL_SPIDER_INTERNAL_LOCAL_RADII_H
#define CGAL_SPIDER_INTERNAL_LOCAL_RADII_H

#include <CGAL/Spider/internal/Mesh_snapshot.h>
#include <CGAL/Spider/internal/Radius_ladder.h>
#include <CGAL/Spider/internal/Site.h>
#include <CGAL/Spider/internal/by_density.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns the mean length of the edges near each vertex, NaN where there are none: a vertex and its neighbours average
/// what they have a few times, so that the length varies slowly.
template <typename Scalar>
std::vector<Scalar> local_edge_lengths(const Mesh_snapshot<Scalar>& mesh)
{
  constexpr int passes = 8; // over about as many vertices as a spider of the default radius
  const std::uint32_t n = static_cast<std::uint32_t>(mesh.number_of_vertices());
  std::vector<Scalar> lengths(n), next(n);
  const auto mean_over_neighbours = [&](std::uint32_t v, const auto& value_at) {
    Scalar sum = 0;
    int count = 0;
    const auto add = [&](std::uint32_t neighbour) {
      const Scalar value = value_at(neighbour);
      if(value > 0 && std::isfinite(value))
      {
        sum += value;
        ++count;
      }
    };
    if(mesh.first_corner(v) != Mesh_snapshot<Scalar>::null_halfedge())
      visit_corners(mesh, mesh.first_corner(v), [&](std::uint32_t corner) {
        const auto edge = mesh.other_edges(corner).first;
        add(mesh.source(edge));
        add(mesh.target(edge));
      });
    return count > 0 ? sum / count : nan<Scalar>();
  };

  for(std::uint32_t v = 0; v < n; ++v)
    lengths[v] = mean_over_neighbours(v, [&](std::uint32_t w) { return (mesh.point(w) - mesh.point(v)).stableNorm(); });
  for(int pass = 0; pass < passes; ++pass)
  {
    for(std::uint32_t v = 0; v < n; ++v)
      next[v] = (lengths[v] + mean_over_neighbours(v, [&](std::uint32_t w) { return lengths[w]; })) / 2;
    std::swap(lengths, next);
  }
  return lengths;
}

/// returns the best radii, in edge lengths, for vertices among short, longer and long edges: one class for each time
/// that edges' lengths double.
template <typename ConcurrencyTag, typename Ladder, typename Scalar>
Table_by_density<Scalar> best_radii(const Ladder& ladder, const std::vector<Scalar>& edge_lengths)
{
  std::vector<std::uint32_t> order;
  for(std::uint32_t v : ladder.vertices_of_faces())
    if(edge_lengths[v] > 0)
      order.push_back(v);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t v, std::uint32_t w) { return edge_lengths[v] < edge_lengths[w]; });
  std::vector<Scalar> lengths;
  for(std::uint32_t v : order)
    lengths.push_back(edge_lengths[v]);

  Table_by_density<Scalar> radii;
  for(const auto& among : density_classes(lengths, 1, Ladder::sample_size))
    if(const auto radius = ladder.template best_radius<ConcurrencyTag>(
         {order.begin() + among.begin, order.begin() + among.end}, [&](std::uint32_t v) { return edge_lengths[v]; }))
      radii.add(among.edge_length, *radius);
  return radii;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LOCAL_RADII_H
