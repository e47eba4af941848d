// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A radius for each vertex, where the density of vertices varies over the mesh.

#ifndef CGAL_SPIDER_INTERNAL_LOCAL_RADII_H
#define CGAL_SPIDER_INTERNAL_LOCAL_RADII_H

#include <CGAL/Spider/internal/Mesh_snapshot.h>
#include <CGAL/Spider/internal/Radius_ladder.h>
#include <CGAL/Spider/internal/Site.h>

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

/// What is best where edges are of some length.
template <typename Scalar>
struct Radius_at_density
{
  Scalar edge_length, radius_in_edges;
};

/// returns the best radii for vertices among short, longer and long edges, in that order: as many classes as the edges'
/// lengths span octaves, with the same number of vertices each.
template <typename ConcurrencyTag, typename Ladder, typename Scalar>
std::vector<Radius_at_density<Scalar>> best_radii(const Ladder& ladder, const std::vector<Scalar>& edge_lengths)
{
  std::vector<std::uint32_t> order;
  for(std::uint32_t v : ladder.vertices_of_faces())
    if(edge_lengths[v] > 0)
      order.push_back(v);
  std::vector<Radius_at_density<Scalar>> radii;
  if(order.empty())
    return radii;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t v, std::uint32_t w) { return edge_lengths[v] < edge_lengths[w]; });

  constexpr std::size_t few = 20, most_classes = 8; // a twentieth at each end may be exceptional
  const auto quantile = [&](std::size_t part, std::size_t of) {
    return edge_lengths[order[std::min(part * order.size() / of, order.size() - 1)]];
  };
  const Scalar octaves = std::ceil(std::log2(quantile(few - 1, few) / quantile(1, few)));
  const std::size_t classes = std::max<std::size_t>(
    1, std::min({most_classes, static_cast<std::size_t>(octaves), order.size() / Ladder::sample_size}));
  for(std::size_t i = 0; i < classes; ++i)
  {
    const auto from = order.begin() + i * order.size() / classes, to = order.begin() + (i + 1) * order.size() / classes;
    const auto radius =
      ladder.template best_radius<ConcurrencyTag>({from, to}, [&](std::uint32_t v) { return edge_lengths[v]; });
    if(radius)
      radii.push_back({quantile(2 * i + 1, 2 * classes), *radius});
  }
  return radii;
}

/// interpolates, logarithmically, and keeps what is best at the ends beyond them.
template <typename Scalar>
Scalar radius_in_edges(const std::vector<Radius_at_density<Scalar>>& radii, Scalar edge_length)
{
  const auto above = std::upper_bound(radii.begin(), radii.end(), edge_length,
                                      [](Scalar length, const auto& radius) { return length < radius.edge_length; });
  if(above == radii.begin())
    return radii.front().radius_in_edges;
  const auto below = above - 1;
  if(above == radii.end() || !(edge_length > 0))
    return below->radius_in_edges;
  const Scalar share = std::log(edge_length / below->edge_length) / std::log(above->edge_length / below->edge_length);
  return below->radius_in_edges * std::pow(above->radius_in_edges / below->radius_in_edges, share);
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LOCAL_RADII_H
