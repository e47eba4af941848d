// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The estimator that Spider adds to the paper's: one height field z(x, y) fitted to samples of all limbs at once.
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
// - Limbs are walked in lockstep, and their samples only leave sums of powers behind.

#ifndef CGAL_SPIDER_INTERNAL_SURFACE_FIT_H
#define CGAL_SPIDER_INTERNAL_SURFACE_FIT_H

#include <CGAL/Spider/internal/Limb_bundle.h>
#include <CGAL/Spider/internal/Limb_directions.h>
#include <CGAL/Spider/internal/Limb_moments.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Spider_fit.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/Star.h>
#include <CGAL/Spider/internal/height_field.h>
#include <CGAL/Spider/internal/least_squares.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// `surface_fit` by a height field of the given degree.
template <typename View, int Degree>
class Surface_fit
{
  using Scalar = typename View::Scalar;
  using Basis = Height_field_basis<Degree>;
  using Values = Lanes<Scalar>;
  using Moments = Limb_moments<Scalar, Degree>;
  using Functions = typename Moments::Functions;

public:
  /// A surface that isn't a height field, such as that around a sharp ridge, has several normals from which the next
  /// round leads elsewhere: the iteration rests when the fit doesn't get better.
  static constexpr bool rests_at_best_fit = true;

  explicit Surface_fit(const Options<Scalar>& options) : options_(options) {}

  /// grows a spider and fits it.
  Spider_fit<Scalar> operator()(const View& view,
                                const Site<View>& site,
                                const Spider_frame<Scalar>& frame,
                                Scalar radius,
                                Spider_extent<Scalar>& extent)
  {
    directions_.set(options_.number_of_directions_at(radius));
    const Star<View> star(view, site, Local_coordinates<Scalar>(site.point, frame, radius));
    const Functions origin = functions_at_origin(view, site, star.local);
    bundles_.resize(directions_.cosines.size());
    for(std::size_t i = 0; i < bundles_.size(); ++i)
    {
      const int count = directions_.limbs_in_bundle(i);
      Limb_bundle<View> limbs(view, site, star, directions_.cosines[i], directions_.sines[i], count,
                              options_.limb_rule.measure);
      extent.number_of_segments += sample(limbs, origin, bundles_[i]);
      for(int limb = 0; limb < count; ++limb)
        extent.add(limbs.reached(limb), limbs.end(limb), limbs.climbs(limb));
    }
    if(!(extent.reached > 0))
      return {};

    // Weight on the rim is against noise. Where neglected terms show, they matter more than noise does, and it is withdrawn.
    const Scalar length_of_segments = extent.reached / extent.number_of_segments;
    const Scalar independent_values = vertices_in_disc(length_of_segments);
    const auto without_rim = solve<Basis::fitted>(sum_of_bundles(), independent_values);
    const Values rim_weight = weight_of_rim(length_of_segments) * Values(1 - without_rim.share_of_neglected);
    for(Bundle& bundle : bundles_)
      bundle.moments.add(bundle.end, bundle.functions_at_end, bundle.is_complete * rim_weight);
    return fit(solve<Basis::fitted>(sum_of_bundles(), independent_values), extent.is_complete);
  }

private:
  struct Bundle
  {
    Moments moments;
    Functions functions_at_end;
    Values end; ///< how far along their directions limbs got
    Values is_complete;
  };

  /// On average over its directions a line crosses 2 / pi edges per length and length of edges per area (Crofton), and
  /// equilateral triangles have edges of the length 2 sqrt(3) per area and edge length.
  static constexpr Scalar segments_per_edge_length() { return Scalar(2.2); }

  /// A segment at the distance y from the query point stands for an area, in proportion to y. Long ones tell more than
  /// short ones, but less than by their length, since they see the same few vertices: they count by its root. Only those
  /// below a hundredth of the radius count by their length, lest rounding counts where a limb passes through a vertex.
  static Values weight_of_length(const Values& length)
  {
    return length / square_root(length + Values(Scalar(0.01)));
  }

  /// Beyond the rim, noise is that of the samples at the rim for about an edge length: measured, as the weight at
  /// which the variance of curvature is least, on meshes with noise of all tessellations. A spider that is smaller than
  /// an edge doesn't know what is beyond; there the rim stands for no more than the radius.
  static Values weight_of_rim(Scalar length_of_segments)
  {
    const Scalar length = std::min(length_of_segments, 1 / segments_per_edge_length());
    return Values(segments_per_edge_length()) * weight_of_length(Values(length));
  }

  /// A disc of the radius holds 2 pi / sqrt(3) vertices per square of the edge length.
  static Scalar vertices_in_disc(Scalar length_of_segments)
  {
    constexpr Scalar per_square = Scalar(3.63);
    const Scalar edge_length = segments_per_edge_length() * length_of_segments;
    return per_square / (edge_length * edge_length);
  }

  /// returns the terms at the query point, interpolated from the vertices that it lies between, and its height, 0.
  static Functions functions_at_origin(const View& view, const Site<View>& site, const Local_coordinates<Scalar>& local)
  {
    Functions functions;
    functions.fill(Values(0));
    for(int i = 0; i < 3; ++i)
    {
      if(!(site.weights[i] > 0))
        continue;
      const Vec3<Scalar> a = local(view.point(site.vertices[i]));
      const auto at_vertex = Basis::curved_at(a.x(), a.y());
      for(int k = 0; k < Basis::curved; ++k)
        functions[k] += Values(site.weights[i] * at_vertex[k]);
    }
    return functions;
  }

  static Values between(const Values& from, const Values& to, const Values& share) { return from + share * (to - from); }

  /// walks limbs, with a sample in the middle of each of their segments; returns how many segments they have.
  static Scalar sample(Limb_bundle<View>& limbs, const Functions& origin, Bundle& bundle)
  {
    Moments& moments = bundle.moments;
    moments.clear();
    Functions& at = bundle.functions_at_end;
    at = origin;
    Values segments(0);
    limbs.walk([&](const Segments<Scalar>& next) {
      const auto source = Basis::curved_at(next.source.x, next.source.y);
      const auto target = Basis::curved_at(next.target.x, next.target.y);
      Functions middle;
      for(int k = 0; k <= Basis::curved; ++k)
      {
        const Values crossing = k < Basis::curved ? between(source[k], target[k], next.crossing)
                                                  : between(next.source.z, next.target.z, next.crossing);
        middle[k] = between(at[k], crossing, next.middle_share);
        at[k] = between(at[k], crossing, next.share);
      }
      moments.add(next.middle, middle, next.middle * weight_of_length(next.gain));
      segments += next.share;
    });
    bundle.end = limbs.end_along_direction();
    bundle.is_complete = limbs.is_complete();
    return segments.sum();
  }

  Normal_equations<Scalar, Basis::size> sum_of_bundles() const
  {
    Normal_equations<Values, Basis::size> equations;
    for(std::size_t i = 0; i < bundles_.size(); ++i)
      bundles_[i].moments.add_to(equations, directions_.cosines[i], directions_.sines[i]);

    Normal_equations<Scalar, Basis::size> sum;
    for(int i = 0; i < Basis::size; ++i)
    {
      for(int k = 0; k <= i; ++k)
        sum.matrix[i][k] = equations.matrix[i][k].sum();
      sum.right_side[i] = equations.right_side[i].sum();
    }
    sum.squared_values = equations.squared_values.sum();
    return sum;
  }

  static Spider_fit<Scalar> fit(const Least_squares_fit<Scalar, Basis::size>& field, bool is_complete)
  {
    // A spider inside one face, or inside coplanar ones, sees a plane, and no more than that if it is complete.
    const auto& determined = field.determined;
    const bool is_flat = is_complete && !determined[Basis::isotropic];
    if(!determined[Basis::constant] || !determined[Basis::x_term] || !determined[Basis::y_term] ||
       !(determined[Basis::isotropic] || is_flat))
      return {};
    // Few vertices, or few limbs, may tell how much the surface bends but not in which direction it does so more.
    const bool has_directions = determined[Basis::difference] && determined[Basis::mixed] && !is_flat;
    const auto& c = field.coefficients;
    const Scalar difference = has_directions ? c[Basis::difference] : 0, mixed = has_directions ? c[Basis::mixed] : 0;
    Spider_fit<Scalar> fit = principal_curvatures_of_graph<Scalar>(
      c[Basis::x_term], c[Basis::y_term], 2 * (c[Basis::isotropic] + difference), 2 * mixed,
      2 * (c[Basis::isotropic] - difference));
    fit.is_whole = has_directions || is_flat;
    fit.residual = field.residual;
    return fit;
  }

  const Options<Scalar>& options_;
  Limb_directions<Scalar> directions_;
  std::vector<Bundle> bundles_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SURFACE_FIT_H
