// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Limbs for each vertex, where the scale of the shape varies over the mesh. As `Error_balance` does for a whole
// mesh, it tells bias from noise by the steps between answers of successive radii, here averaged over neighbourhoods.
// These are few values, so what noise contributes must be known well, and is told by the whole mesh.

#ifndef CGAL_SPIDER_INTERNAL_ADAPTIVE_LIMBS_H
#define CGAL_SPIDER_INTERNAL_ADAPTIVE_LIMBS_H

#include <CGAL/Spider/internal/Error_balance.h>
#include <CGAL/Spider/internal/Neighbours.h>
#include <CGAL/Spider/internal/by_density.h>
#include <CGAL/Spider/internal/limb_elongations.h>
#include <CGAL/Spider/internal/local_radii.h>
#include <CGAL/Spider/internal/local_steps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns the variance of mean curvature at a rung, but for a factor: a law whose steps are within 15 % of those measured
/// on noisy planes and spheres.
template <typename Scalar>
Scalar variance_by_law(Scalar k)
{
  const Scalar deviation = 1 / (std::pow(rung(k), Scalar(2.75)) + Scalar(4.5));
  return deviation * deviation;
}

/// returns how large noise is among short, longer and long edges, as a multiple of what `variance_by_law()` tells for
/// edges of length one: one class of vertices for each time that their edges' lengths grow fourfold. Some part of each
/// is smooth enough that the first step shows nothing but noise.
template <typename Scalar>
Table_by_density<Scalar> noise_by_density(const std::vector<Local_steps<Scalar>>& steps,
                                          const std::vector<Scalar>& edge_lengths)
{
  std::vector<std::pair<Scalar, Scalar>> found; // the edges' length at each vertex, and noise
  for(std::size_t v = 0; v < steps.size(); ++v)
    if(const Scalar l = edge_lengths[v]; l > 0 && std::isfinite(steps[v][0]))
      found.emplace_back(l, steps[v][0] / (variance_by_law(Scalar(0)) - variance_by_law(Scalar(1))) * l * l);
  std::sort(found.begin(), found.end());
  std::vector<Scalar> lengths, variances;
  for(const auto& [length, variance] : found)
  {
    lengths.push_back(length);
    variances.push_back(variance);
  }

  constexpr int octaves_per_class = 2;
  constexpr std::size_t least_size = 512;
  constexpr Scalar quarter_of_all_by_chance = Scalar(1.15); // the least quarter is as low as that without any bias
  Table_by_density<Scalar> noise;
  for(const auto& among : density_classes(lengths, octaves_per_class, least_size))
  {
    const auto begin = variances.begin() + among.begin, end = variances.begin() + among.end;
    const auto quartile = begin + (end - begin) / 4;
    std::nth_element(begin, quartile, end);
    noise.add(among.edge_length, quarter_of_all_by_chance * *quartile);
  }
  return noise;
}

/// returns the rung of least error near a vertex, between rungs too, given noise as a multiple of
/// `variance_by_law()`; nothing where steps tell nothing.
template <typename Scalar>
std::optional<Scalar> local_rung(const Local_steps<Scalar>& steps, Scalar noise)
{
  constexpr Scalar rounding = Scalar(1e-9); // a surface that bends by less per edge is a plane
  constexpr Scalar surely = Scalar(1.5); // a mean over a neighbourhood is higher than that by chance one time in fifty
  constexpr Scalar part_of_next = Scalar(0.6), least_part_of_next = Scalar(0.5);
  int n = 0;
  while(n < int(steps.size()) && std::isfinite(steps[n]))
    ++n;
  if(n == 0 || !(*std::max_element(steps.begin(), steps.begin() + n) > rounding * rounding))
    return {};

  // Bias grows with the radius, so that a step is at least half as large as the next one, at the square of the radius.
  // If later steps show none, there is hardly any in this one, unless waves have vanished already.
  std::array<Scalar, number_of_adaptive_rungs> variances, biased{};
  for(int k = 0; k <= n; ++k)
    variances[k] = noise * variance_by_law(Scalar(k));
  const auto excess = [&](int k, Scalar tolerance) {
    return std::sqrt(std::max(Scalar(0), steps[k] - tolerance * (variances[k] - variances[k + 1])));
  };
  Scalar largest_later = 0;
  for(int k = n - 1; k >= 0; --k)
  {
    const Scalar likely = std::min(excess(k, Scalar(1)), part_of_next * largest_later);
    biased[k] = std::max({likely, excess(k, surely), k + 1 < n ? least_part_of_next * biased[k + 1] : Scalar(0)});
    largest_later = std::max(largest_later, biased[k]);
  }

  std::array<Scalar, number_of_adaptive_rungs> errors;
  Scalar bias = biased[0]; // at the first rung as much as in the first step, by the square of the radius
  for(int k = 0; k <= n; ++k)
  {
    errors[k] = variances[k] + bias * bias;
    bias += biased[k];
  }
  return least_between(errors, n + 1);
}

/// returns how large the difference of tensors is that noise makes between a rung and the one that `blurring_at()`
/// compares it with.
template <typename Scalar>
Scalar size_of_noise(Scalar noise, Scalar rung)
{
  const Scalar variances = noise * (variance_by_law(rung) - variance_by_law(rung + rungs_apart));
  return std::sqrt(square_of_tensor_by_variance * std::max(Scalar(0), variances));
}

/// Limbs near each vertex.
template <typename Scalar>
struct Adaptive_limbs
{
  std::vector<Scalar> radii;             ///< NaN where there are no edges of finite, positive length
  std::vector<Vec3<Scalar>> elongations; ///< where they are asked for: see `elongation_of()`
};

template <typename ConcurrencyTag, typename Ladder>
Adaptive_limbs<typename Ladder::Scalar> adaptive_limbs(const Ladder& ladder, typename Ladder::Scalar undecided_in_edges,
                                                       bool elongate)
{
  using Scalar = typename Ladder::Scalar;
  constexpr int rounds = 10; // so that the radius varies as slowly as limbs need it
  const Neighbours neighbours(ladder.mesh());
  const std::vector<Scalar> edge_lengths = local_edge_lengths(ladder.mesh());
  const auto climbed = climb<ConcurrencyTag>(ladder, neighbours, edge_lengths);
  const auto steps = local_steps<ConcurrencyTag>(climbed, neighbours, edge_lengths.size());
  const auto noise = noise_by_density(steps, edge_lengths);
  const auto noise_at = [&](std::size_t v) {
    return noise.empty() ? Scalar(0) : noise(edge_lengths[v]) / (edge_lengths[v] * edge_lengths[v]);
  };

  std::vector<std::array<Scalar, 2>> sums(steps.size()); // of rungs, and whether there is one
  for(std::size_t v = 0; v < steps.size(); ++v)
    if(edge_lengths[v] > 0)
      if(const auto best = local_rung(steps[v], noise_at(v)))
        sums[v] = {*best, Scalar(1)};
  neighbours.average<ConcurrencyTag>(sums, rounds);

  std::vector<Scalar> rungs, sizes_of_noise;
  Adaptive_limbs<Scalar> limbs;
  for(std::size_t v = 0; v < steps.size(); ++v)
  {
    const bool is_decided = sums[v][1] > 0;
    rungs.push_back(is_decided ? sums[v][0] / sums[v][1] : Scalar(0));
    sizes_of_noise.push_back(size_of_noise(noise_at(v), rungs[v]));
    limbs.radii.push_back(edge_lengths[v] * (is_decided ? rung(rungs[v]) : undecided_in_edges));
  }
  if(elongate)
  {
    limbs.elongations = limb_elongations<ConcurrencyTag>(climbed, neighbours, rungs, sizes_of_noise);
    for(std::size_t v = 0; v < steps.size(); ++v) // to ellipses of the same area
      limbs.radii[v] *= std::sqrt(std::max(Scalar(1), limbs.elongations[v].norm()));
  }
  return limbs;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_ADAPTIVE_LIMBS_H
