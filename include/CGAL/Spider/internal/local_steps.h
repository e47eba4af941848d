// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How much curvature differs by between successive radii, near each vertex of a mesh.

#ifndef CGAL_SPIDER_INTERNAL_LOCAL_STEPS_H
#define CGAL_SPIDER_INTERNAL_LOCAL_STEPS_H

#include <CGAL/Spider/internal/Estimate_blend.h>
#include <CGAL/Spider/internal/Neighbours.h>
#include <CGAL/Spider/internal/Radius_ladder.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// Adaptive radii are 2 to 8 edges: beyond, flat places would cost more than all others, and gain what is little
/// already.
constexpr int number_of_adaptive_rungs = 5;

/// What curvature differs by between successive rungs, at a vertex or near it, in units of one over the edge length
/// or squares of that; NaN where there is nothing.
template <typename Scalar>
using Local_steps = std::array<Scalar, number_of_adaptive_rungs - 1>;

/// By what noise adds to it, the square of a difference of tensors is that many times as large as what the variances of
/// mean curvature differ by: measured on noisy planes and spheres.
constexpr int square_of_tensor_by_variance = 3;

template <typename Scalar>
using Tensor3 = Eigen::Matrix<Scalar, 3, 3>;

/// A vertex with the curvature tensors at the first rungs, in units of one over the edge length, up to the last radius
/// at which there is an estimate that no border spoils.
template <typename Scalar>
struct Climbed_vertex
{
  std::uint32_t vertex = 0;
  Vec3<Scalar> normal = nan_vec3<Scalar>();
  int usable = 0;
  std::array<Tensor3<Scalar>, number_of_adaptive_rungs> tensors;
};

template <typename Scalar>
Climbed_vertex<Scalar> climbed_vertex(std::uint32_t v, const std::vector<Estimate<Scalar>>& estimates,
                                      Scalar edge_length)
{
  Climbed_vertex<Scalar> result;
  result.vertex = v;
  result.normal = estimates[0].normal;
  for(; result.usable < number_of_adaptive_rungs; ++result.usable)
  {
    const Estimate<Scalar>& e = estimates[result.usable];
    const Tensor3<Scalar> tensor = edge_length * (e.min_curvature * e.min_direction * e.min_direction.transpose() +
                                                  e.max_curvature * e.max_direction * e.max_direction.transpose());
    if(e.meets_border || !tensor.allFinite())
      break;
    result.tensors[result.usable] = tensor;
  }
  return result;
}

/// returns the ranks of the vertices that climb the ladder: well spread, no two of them have a common neighbour, since
/// their spiders would see much the same. That is one vertex in ten. On small meshes they are closer.
template <typename Ladder, typename Scalar>
std::vector<std::uint32_t> climbers(const Ladder& ladder, const Neighbours& neighbours,
                                    const std::vector<Scalar>& edge_lengths)
{
  constexpr std::size_t few = Ladder::sample_size;
  std::vector<std::uint32_t> all;
  for(std::uint32_t v : ladder.vertices_of_faces())
    if(edge_lengths[v] > 0)
      all.push_back(v);
  all = subsample(std::move(all), all.size()); // in any order but the mesh's
  std::vector<std::uint32_t> chosen;
  for(int edges = 2; edges >= 0 && chosen.size() < few; --edges)
    chosen = neighbours.apart(all, edges);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

/// returns those of them with two estimates or more.
template <typename ConcurrencyTag, typename Ladder, typename Scalar>
std::vector<Climbed_vertex<Scalar>> climb(const Ladder& ladder, const Neighbours& neighbours,
                                          const std::vector<Scalar>& edge_lengths)
{
  std::vector<Climbed_vertex<Scalar>> climbed;
  ladder.template climb<ConcurrencyTag>(climbers(ladder, neighbours, edge_lengths), number_of_adaptive_rungs,
                                        edge_lengths, [&](std::uint32_t v, const auto& estimates) {
                                          climbed.push_back(climbed_vertex(v, estimates, edge_lengths[v]));
                                          if(climbed.back().usable < 2)
                                            climbed.pop_back();
                                        });
  return climbed;
}

/// returns the squares of the steps, averaged over neighbourhoods, and so scaled that noise alone makes them what the
/// variances of mean curvature at the two rungs differ by. A step is what tensors differ by, in all directions: with
/// mean curvature alone, it would take three times as many vertices to tell noise from bias.
template <typename ConcurrencyTag, typename Scalar>
std::vector<Local_steps<Scalar>> local_steps(const std::vector<Climbed_vertex<Scalar>>& climbed,
                                             const Neighbours& neighbours, std::size_t number_of_vertices)
{
  constexpr int rounds = 60; // with fewer, noise that is high by chance passes for bias; with more, scales are mixed
  constexpr int steps = number_of_adaptive_rungs - 1;
  // Means of fourth roots: one fit that is far off, where noise folds the surface, shall not decide for all around it.
  std::vector<std::array<Scalar, 2 * steps>> sums(number_of_vertices); // of these roots, and of their number
  for(const Climbed_vertex<Scalar>& at : climbed)
    for(int k = 0; k + 1 < at.usable; ++k)
    {
      sums[at.vertex][k] = std::sqrt(std::sqrt((at.tensors[k + 1] - at.tensors[k]).norm()));
      sums[at.vertex][steps + k] = 1;
    }
  neighbours.average<ConcurrencyTag>(sums, rounds);

  std::vector<Local_steps<Scalar>> result(sums.size());
  for(std::size_t v = 0; v < sums.size(); ++v)
    for(int k = 0; k < steps; ++k)
    {
      const Scalar root = sums[v][k] / sums[v][steps + k], typical = std::pow(root, 4);
      result[v][k] = typical * typical / square_of_tensor_by_variance;
    }
  return result;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LOCAL_STEPS_H
