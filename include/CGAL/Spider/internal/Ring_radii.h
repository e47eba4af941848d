// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_RING_RADII_H
#define CGAL_SPIDER_INTERNAL_RING_RADII_H

#include <CGAL/Spider/internal/Free_vertices.h>
#include <CGAL/Spider/internal/numbers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// The radii of the rings by which vertices are smoothed: wider from round to round where what the vertices do tells of
/// noise, and narrow where it tells of shape.
template <typename Scalar>
class Ring_radii
{
public:
  explicit Ring_radii(std::vector<Scalar> narrowest) : narrowest_(std::move(narrowest)), radii_(narrowest_) {}

  Scalar operator[](std::size_t v) const { return radii_[v]; }
  Scalar narrowest(std::size_t v) const { return narrowest_[v]; }

  /// adapts the radii to what the ways of vertices have in common with those around, and to what is their own. Noise is
  /// each vertex' own; curvature has neighbours go alike. Since noise goes from round to round, rings narrow again.
  template <typename ConcurrencyTag>
  void adapt(const Free_vertices<Scalar>& free, const std::vector<Vec3<Scalar>>& common,
             const std::vector<Vec3<Scalar>>& own)
  {
    // On a smooth scan with noise the median is 0.033 (doc/Spider/smoothing.md); figures of meshes hardly depend on these.
    constexpr Scalar ratio_of_noise = Scalar(0.05), ratio_of_shape = Scalar(0.25);
    constexpr Scalar widest = 3; // times the narrowest: three halves of the edges around
    const std::vector<Scalar> common_squares = free.template mean_squares_near<ConcurrencyTag>(common);
    const std::vector<Scalar> own_squares = free.template mean_squares_near<ConcurrencyTag>(own);
    for(std::size_t v = 0; v < radii_.size(); ++v)
    {
      const Scalar ratio = common_squares[v] / own_squares[v];
      const Scalar narrowness = std::log(ratio / ratio_of_noise) / std::log(ratio_of_shape / ratio_of_noise);
      const Scalar width = std::isnan(narrowness) ? 0 : 1 - std::clamp(narrowness, Scalar(0), Scalar(1));
      radii_[v] = narrowest_[v] * std::pow(widest, width);
    }
  }

private:
  std::vector<Scalar> narrowest_, radii_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_RING_RADII_H
