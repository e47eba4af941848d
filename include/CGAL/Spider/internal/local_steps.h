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
#include <utility>
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

/// returns how much two estimates at one point differ by, in all directions: with mean curvature alone, it would take
/// three times as many vertices to tell noise from bias.
template <typename Scalar>
Scalar difference(const Estimate<Scalar>& a, const Estimate<Scalar>& b)
{
  const auto mean = [](const Estimate<Scalar>& e) { return (e.min_curvature + e.max_curvature) / 2; };
  const auto deviator = [](const Estimate<Scalar>& e) -> Eigen::Matrix<Scalar, 3, 3> {
    return (e.max_curvature - e.min_curvature) / 2 * directions_tensor(e);
  };
  const Scalar of_means = mean(b) - mean(a); // which counts twice: it is both on the diagonal
  return std::sqrt(2 * of_means * of_means + (deviator(b) - deviator(a)).squaredNorm());
}

/// returns the steps up to the last radius at which there is an estimate that no border spoils.
template <typename Scalar>
Local_steps<Scalar> steps_between(const std::vector<Estimate<Scalar>>& estimates, Scalar edge_length)
{
  Local_steps<Scalar> steps;
  steps.fill(nan<Scalar>());
  for(std::size_t k = 0; k < steps.size() && !estimates[k].meets_border && !estimates[k + 1].meets_border; ++k)
  {
    steps[k] = difference(estimates[k], estimates[k + 1]) * edge_length;
    if(!std::isfinite(steps[k]))
      break;
  }
  return steps;
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

/// returns the squares of the steps, averaged over neighbourhoods, and so scaled that noise alone makes them what the
/// variances of mean curvature at the two rungs differ by.
template <typename ConcurrencyTag, typename Ladder, typename Scalar>
std::vector<Local_steps<Scalar>> local_steps(const Ladder& ladder, const Neighbours& neighbours,
                                             const std::vector<Scalar>& edge_lengths)
{
  constexpr int rounds = 60; // with fewer, noise that is high by chance passes for bias; with more, scales are mixed
  constexpr int steps = number_of_adaptive_rungs - 1;
  // Means of fourth roots: one fit that is far off, where noise folds the surface, shall not decide for all around it.
  std::vector<std::array<Scalar, 2 * steps>> sums(edge_lengths.size()); // of these roots, and of their number
  ladder.template climb<ConcurrencyTag>(climbers(ladder, neighbours, edge_lengths), number_of_adaptive_rungs,
                                        edge_lengths, [&](std::uint32_t v, const auto& estimates) {
                                          const Local_steps<Scalar> found = steps_between(estimates, edge_lengths[v]);
                                          for(int k = 0; k < steps && std::isfinite(found[k]); ++k)
                                          {
                                            sums[v][k] = std::sqrt(std::sqrt(found[k]));
                                            sums[v][steps + k] = 1;
                                          }
                                        });
  neighbours.average<ConcurrencyTag>(sums, rounds);

  constexpr Scalar by_noise = Scalar(3.0); // measured on noisy planes and spheres: 2.4 to 3.1 from step to step
  std::vector<Local_steps<Scalar>> result(sums.size());
  for(std::size_t v = 0; v < sums.size(); ++v)
    for(int k = 0; k < steps; ++k)
    {
      const Scalar root = sums[v][k] / sums[v][steps + k], typical = std::pow(root, 4);
      result[v][k] = typical * typical / by_noise;
    }
  return result;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LOCAL_STEPS_H
