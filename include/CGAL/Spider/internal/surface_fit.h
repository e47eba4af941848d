// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The estimator that Spider adds to the paper's: one height field z(x, y) fitted to the samples of all limbs at once.
//
// - It needn't pass through the query point, which is as noisy as any other, and its gradient is free: curvatures come
//   from its fundamental forms, so the frame may be tilted.
// - A sample at the distance y is weighed by y, so that every piece of area counts the same. The rim weighs more: there
//   a sample also stands for the vertices beyond, whose noise it shares.
// - Facets sag below the surface that they stand for. So a sample isn't compared with the height field, but with the
//   mesh that one would get by moving the vertices onto the height field: the terms are interpolated along edges and
//   along the limb as heights are. A mesh of an exact polynomial of the fitted degree gives that polynomial.
// - A quadric takes what quartic terms do to the rim for curvature. These terms are estimated too, and their effect is
//   taken back as far as the samples prove them.

#ifndef CGAL_SPIDER_INTERNAL_SURFACE_FIT_H
#define CGAL_SPIDER_INTERNAL_SURFACE_FIT_H

#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Samples.h>
#include <CGAL/Spider/internal/Spider_fit.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/height_field.h>
#include <CGAL/Spider/internal/least_squares.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Spider {
namespace internal {

/// `surface_fit` by a height field of the given degree.
template <typename View, int Degree>
class Surface_fit
{
  using Scalar = typename View::Scalar;
  using Basis = Height_field_basis<Degree>;
  using Equations = Normal_equations<Scalar, Basis::size>;
  using Row = typename Equations::Row;

public:
  explicit Surface_fit(const Options<Scalar>& options)
    : options_(options),
      inner_samples_(static_cast<std::size_t>(std::ceil(1 / options.resampling_step - rounding())) - 1)
  {
  }

  /// grows a spider and fits it.
  Spider_fit<Scalar> operator()(const View& view,
                                const Site<View>& site,
                                const Spider_frame<Scalar>& frame,
                                Scalar radius,
                                Spider_extent<Scalar>& extent)
  {
    const int count = options_.number_of_directions_at(radius);
    equations_ = rim_ = Equations();
    crossings_ = 0;
    const Row origin = origin_row(view, site, frame, radius);
    for(int i = 0; i < 2 * count; ++i)
      extent.add(add_limb(view, site, frame, angle_of_direction<Scalar>(i, count), radius, origin));
    if(!(extent.reached > 0))
      return {};

    const Scalar crossings_per_radius = crossings_ / extent.reached;
    equations_.add(rim_, additional_rim_weight(crossings_per_radius));
    const auto field = solve(equations_, Basis::fitted, vertices_in_disc(crossings_per_radius));
    if(!field)
      return {};
    const auto& c = field->coefficients;
    Spider_fit<Scalar> fit = principal_curvatures_of_graph<Scalar>(
      c[monomial(1, 0)], c[monomial(0, 1)], 2 * c[monomial(2, 0)], c[monomial(1, 1)], 2 * c[monomial(0, 2)]);
    fit.residual = field->residual;
    return fit;
  }

private:
  static constexpr Scalar rounding() { return Scalar(1e-9); }

  /// On average over its directions a line crosses 2 / pi edges per length and length of edges per area (Crofton), and
  /// equilateral triangles have edges of the length 2 sqrt(3) per area and edge length.
  static constexpr Scalar crossings_per_edge_length() { return Scalar(2.2); }

  /// Beyond the rim, noise is that of the samples at the rim for about 0.8 edge lengths: measured, as the weight at
  /// which the variance of curvature is least, on meshes with noise of all tessellations. A spider that is smaller than
  /// an edge doesn't know what is beyond; there the rim stands for no more than the radius.
  Scalar additional_rim_weight(Scalar crossings_per_radius) const
  {
    constexpr Scalar edge_lengths = Scalar(0.8);
    const Scalar radii = edge_lengths * crossings_per_edge_length() / crossings_per_radius;
    return std::min(radii, Scalar(1)) / options_.resampling_step;
  }

  /// A disc of the radius holds 2 pi / sqrt(3) vertices per square of the edge length.
  static Scalar vertices_in_disc(Scalar crossings_per_radius)
  {
    constexpr Scalar per_square = Scalar(3.63);
    const Scalar radius_in_edge_lengths = crossings_per_radius / crossings_per_edge_length();
    return per_square * radius_in_edge_lengths * radius_in_edge_lengths;
  }

  /// returns the terms at the query point, interpolated from the vertices that it lies between.
  static Row
  origin_row(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame, Scalar radius)
  {
    Row row{};
    for(int i = 0; i < 3; ++i)
    {
      if(!(site.weights[i] > 0))
        continue;
      const Vec3<Scalar> a = (view.point(site.vertices[i]) - site.point) / radius;
      const Row at_vertex = Basis::at(a.dot(frame.tangent), a.dot(frame.bitangent));
      for(std::size_t k = 0; k < row.size(); ++k)
        row[k] += site.weights[i] * at_vertex[k];
    }
    return row;
  }

  /// A sample, with the terms of the height field there.
  struct Term_sample
  {
    Row row;
    Scalar y, z;

    /// interpolates on the segment to `other`, heights and terms alike.
    Term_sample towards(const Term_sample& other, Scalar share) const
    {
      return {between(row, other.row, share), y + share * (other.y - y), z + share * (other.z - z)};
    }
  };

  static Row between(const Row& from, const Row& to, Scalar share)
  {
    Row row;
    for(std::size_t k = 0; k < row.size(); ++k)
      row[k] = from[k] + share * (to[k] - from[k]);
    return row;
  }

  /// walks a limb and adds its samples, at regular measure and at its end.
  Walk_result<View> add_limb(const View& view,
                             const Site<View>& site,
                             const Spider_frame<Scalar>& frame,
                             Scalar angle,
                             Scalar radius,
                             const Row& origin)
  {
    const Scalar c = std::cos(angle), s = std::sin(angle);
    const Cut<Scalar> cut(site.point, frame.direction(angle), frame.normal, radius);
    const auto terms_at = [&](const Cut_point<Scalar>& a) {
      return Basis::at(a.y * c - a.side * s, a.y * s + a.side * c);
    };

    Term_sample from{origin, 0, 0}, end = from; // the end is where most was reached: a limb may turn back
    Scalar reached = 0;
    std::size_t taken = 0;
    const Walk_result<View> walk = walk_limb(view, site, cut, options_.limb_measure, [&](const Step<View>& step) {
      const Row crossing =
        step.exit ? between(terms_at(step.exit->source), terms_at(step.exit->target), step.crossing) : origin;
      const Term_sample to{between(from.row, crossing, step.share), step.y, step.z};
      sample_segment(step.from, step.to, options_.resampling_step, inner_samples_, taken, [&](Scalar share) {
        const Term_sample sample = from.towards(to, share);
        equations_.add(sample.row, sample.z, std::abs(sample.y));
      });
      crossings_ += step.share;
      from = to;
      if(step.to >= reached)
      {
        reached = step.to;
        end = to;
      }
    });
    if(reached - Scalar(taken) * options_.resampling_step > rounding())
      equations_.add(end.row, end.z, std::abs(end.y));
    if(walk.end == radius_reached)
      rim_.add(end.row, end.z, std::abs(end.y));
    return walk;
  }

  const Options<Scalar>& options_;
  std::size_t inner_samples_; ///< of a limb, its end not among them
  Equations equations_, rim_;
  Scalar crossings_ = 0;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SURFACE_FIT_H
