// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A radius for each vertex, where the scale of the shape varies over the mesh. As `Error_balance` does for a whole mesh,
// it tells bias from noise by the steps between answers of successive radii, here averaged over neighbourhoods. These
// are few values, so what noise contributes must be known well, and is told by the whole mesh.

#ifndef CGAL_SPIDER_INTERNAL_ADAPTIVE_RADII_H
#define CGAL_SPIDER_INTERNAL_ADAPTIVE_RADII_H

#include <CGAL/Spider/internal/Error_balance.h>
#include <CGAL/Spider/internal/Neighbours.h>
#include <CGAL/Spider/internal/local_radii.h>
#include <CGAL/Spider/internal/local_steps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns the variance of mean curvature at a rung, but for a factor: as measured on planes and spheres.
template <typename Scalar>
Scalar variance_by_law(int k)
{
  const Scalar r = rung(Scalar(k)), deviation = 1 / (r * r * (r + 4));
  return deviation * deviation;
}

/// How large noise is where edges are of some length.
template <typename Scalar>
struct Noise_at_density
{
  Scalar edge_length, variance; ///< the latter in multiples of what `variance_by_law()` tells for edges of length one
};

/// returns how large noise is among short, longer and long edges, in that order: one class of vertices for each time
/// that their edges' lengths grow fourfold. Some part of each is smooth enough that the first step shows nothing but
/// noise.
template <typename Scalar>
std::vector<Noise_at_density<Scalar>> noise_by_density(const std::vector<Local_steps<Scalar>>& steps,
                                                       const std::vector<Scalar>& edge_lengths)
{
  std::vector<Noise_at_density<Scalar>> found; // one for each vertex, and then one for each class
  for(std::size_t v = 0; v < steps.size(); ++v)
    if(const Scalar l = edge_lengths[v]; l > 0 && std::isfinite(steps[v][0]))
      found.push_back({l, steps[v][0] / (variance_by_law<Scalar>(0) - variance_by_law<Scalar>(1)) * l * l});
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.edge_length < b.edge_length; });
  if(found.empty())
    return found;

  constexpr std::size_t few = 20, most_classes = 8, least_size = 512; // a twentieth at each end may be exceptional
  const auto length_at = [&](std::size_t part, std::size_t of) {
    return found[std::min(part * found.size() / of, found.size() - 1)].edge_length;
  };
  const std::size_t wanted =
    static_cast<std::size_t>(std::ceil(std::log2(length_at(few - 1, few) / length_at(1, few)) / 2));
  const std::size_t classes = std::max<std::size_t>(1, std::min({most_classes, wanted, found.size() / least_size}));

  constexpr Scalar quarter_of_all_by_chance = Scalar(1.15); // the least quarter is as low as that without any bias
  std::vector<Noise_at_density<Scalar>> result;
  for(std::size_t i = 0; i < classes; ++i)
  {
    std::vector<Scalar> variances;
    for(std::size_t j = i * found.size() / classes; j < (i + 1) * found.size() / classes; ++j)
      variances.push_back(found[j].variance);
    const auto quartile = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 4);
    std::nth_element(variances.begin(), quartile, variances.end());
    result.push_back({length_at(2 * i + 1, 2 * classes), quarter_of_all_by_chance * *quartile});
  }
  return result;
}

/// interpolates, logarithmically, and keeps what is at the ends beyond them.
template <typename Scalar>
Scalar noise_at(const std::vector<Noise_at_density<Scalar>>& noise, Scalar edge_length)
{
  const auto above = std::upper_bound(noise.begin(), noise.end(), edge_length,
                                      [](Scalar length, const auto& at) { return length < at.edge_length; });
  if(above == noise.begin())
    return noise.front().variance;
  const auto below = above - 1;
  if(above == noise.end() || !(below->variance > 0))
    return below->variance;
  const Scalar share = std::log(edge_length / below->edge_length) / std::log(above->edge_length / below->edge_length);
  return below->variance * std::pow(above->variance / below->variance, share);
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
    variances[k] = noise * variance_by_law<Scalar>(k);
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

/// returns a radius for each vertex; NaN where there are no edges of finite, positive length.
template <typename ConcurrencyTag, typename Ladder>
std::vector<typename Ladder::Scalar> adaptive_radii(const Ladder& ladder, typename Ladder::Scalar undecided_in_edges)
{
  using Scalar = typename Ladder::Scalar;
  constexpr int rounds = 10; // so that the radius varies as slowly as limbs need it
  const Neighbours neighbours(ladder.mesh());
  const std::vector<Scalar> edge_lengths = local_edge_lengths(ladder.mesh());
  const auto steps = local_steps<ConcurrencyTag>(ladder, neighbours, edge_lengths);
  const auto noise = noise_by_density(steps, edge_lengths);

  std::vector<std::array<Scalar, 2>> rungs(steps.size()); // and whether there is one
  for(std::size_t v = 0; v < steps.size(); ++v)
    if(const Scalar l = edge_lengths[v]; l > 0)
      if(const auto best = local_rung(steps[v], noise.empty() ? Scalar(0) : noise_at(noise, l) / (l * l)))
        rungs[v] = {*best, Scalar(1)};
  neighbours.average<ConcurrencyTag>(rungs, rounds);

  std::vector<Scalar> radii(steps.size());
  for(std::size_t v = 0; v < steps.size(); ++v)
    radii[v] = edge_lengths[v] * (rungs[v][1] > 0 ? rung(rungs[v][0] / rungs[v][1]) : undecided_in_edges);
  return radii;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_ADAPTIVE_RADII_H
