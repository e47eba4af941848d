// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SPIDER_SAMPLES_H
#define CGAL_SPIDER_INTERNAL_SPIDER_SAMPLES_H

#include <CGAL/Spider/internal/Bundle_samples.h>
#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/Limb_directions.h>
#include <CGAL/Spider/internal/Sample_sizes.h>
#include <CGAL/Spider/internal/Spider_fit.h>
#include <CGAL/Spider/internal/height_field.h>
#include <CGAL/Spider/internal/least_squares.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// All samples of a spider, bundle by bundle, up to a share of the radius in whose units they are.
template <typename Scalar, int Degree>
struct Spider_samples
{
  using Basis = Height_field_basis<Degree>;

  std::vector<Bundle_samples<Scalar, Degree>> bundles;
  Spider_extent<Scalar> extent;
  Scalar share_of_radius = 1, short_length = 0;

  void begin(std::size_t number_of_bundles, Scalar share, Scalar short_length_of_segments)
  {
    bundles.resize(number_of_bundles);
    extent = {};
    share_of_radius = share;
    short_length = short_length_of_segments;
  }

  /// adds samples at the limbs' ends, given a share of their weight. They weigh as much as segments of 0.4 edge
  /// lengths, and slopes are taken times 0.35 edge lengths: measured, as where the variance of curvature is least, or
  /// within 1 % of that, on meshes with noise at radii of 4 to 12 edge lengths. By heights alone, which do best as
  /// segments of an edge length, errors are a tenth larger at a radius of four. For a spider that is smaller than an
  /// edge, its radius stands for an edge length.
  void add_ends(Scalar share)
  {
    // On average over its directions a line crosses 2 / pi edges per length and length of edges per area (Crofton), and
    // equilateral triangles have edges of the length 2 sqrt(3) per area and edge length.
    constexpr Scalar segments_per_edge_length = Scalar(2.2);
    constexpr Scalar length_of_segments = Scalar(0.4), length_by_slope = Scalar(0.35); // in edge lengths
    constexpr Scalar square_of_edge_by_doubled_area = Scalar(1.1547005); // of equilateral triangles: 2 / sqrt(3)
    const Scalar edge_length =
      std::min(std::sqrt(square_of_edge_by_doubled_area * sizes().doubled_area()), share_of_radius);
    const Scalar weight = share * length_of_segments * segments_per_edge_length * share_of_radius;
    for(auto& bundle : bundles)
      bundle.add_ends(edge_length / segments_per_edge_length, weight, length_by_slope * edge_length, short_length);
  }

  Sample_sizes<Scalar> sizes() const
  {
    Sample_sizes<Scalar> sum;
    for(const auto& bundle : bundles)
      sum += bundle.sizes();
    return sum;
  }

  Normal_equations<Scalar, Basis::size> equations(const Limb_directions<Scalar>& directions) const
  {
    Normal_equations<Lanes<Scalar>, Basis::size> of_limbs;
    for(std::size_t i = 0; i < bundles.size(); ++i)
      bundles[i].moments().add_to(of_limbs, directions.cosines[i], directions.sines[i]);

    Normal_equations<Scalar, Basis::size> sum;
    for(int i = 0; i <= Basis::size; ++i)
      for(int k = i; k <= Basis::size; ++k)
        sum.products[i][k] = of_limbs.products[i][k].sum();
    return sum;
  }
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SPIDER_SAMPLES_H
