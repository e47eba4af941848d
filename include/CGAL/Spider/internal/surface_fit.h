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
//   taken back by a share: the larger curvature lets expect them to be, and the less noise there is, the more of it.
// - Limbs are walked in lockstep, and their samples only leave sums of powers behind.

#ifndef CGAL_SPIDER_INTERNAL_SURFACE_FIT_H
#define CGAL_SPIDER_INTERNAL_SURFACE_FIT_H

#include <CGAL/Spider/internal/Limb_bundle.h>
#include <CGAL/Spider/internal/Limb_directions.h>
#include <CGAL/Spider/internal/Limb_moments.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Sample_sizes.h>
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
      sample(limbs, origin, bundles_[i]);
      for(int limb = 0; limb < count; ++limb)
        extent.add(limbs.reached(limb), limbs.end(limb), limbs.climbs(limb));
    }
    if(!(extent.reached > 0))
      return {};

    // Weight on the rim is against noise. Where neglected terms matter more than noise does, it is withdrawn.
    const auto without_rim = solve_bundles();
    add_rim(1 - without_rim.share_of_neglected);
    return fit(solve_bundles(), extent.is_complete);
  }

private:
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

  struct Bundle
  {
    Moments moments;
    Functions functions_at_end;
    Values end; ///< how far along their directions limbs got
    Values is_complete;
    Sample_sizes<Scalar> sizes;
  };

  /// Beyond the rim, noise is that of the samples at the rim for about an edge length: measured, as the weight at
  /// which the variance of curvature is least, on meshes with noise of all tessellations. A spider that is smaller than
  /// an edge doesn't know what is beyond; there the rim stands for no more than the radius.
  void add_rim(Scalar share)
  {
    constexpr Scalar square_of_edge_by_doubled_area = Scalar(1.1547005); // of equilateral triangles: 2 / sqrt(3)
    const Scalar edge_length =
      std::min(std::sqrt(square_of_edge_by_doubled_area * sum_of_sizes().doubled_area()), Scalar(1));
    const Values length(edge_length / segments_per_edge_length()),
      weight_at_rim = Values(share * segments_per_edge_length()) * weight_of_length(length);
    for(Bundle& bundle : bundles_)
    {
      const Values weight = bundle.is_complete * weight_at_rim;
      bundle.moments.add(bundle.end, bundle.functions_at_end, weight);
      bundle.sizes.add_weight(length, weight);
    }
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

  /// walks limbs, with a sample in the middle of each of their segments.
  static void sample(Limb_bundle<View>& limbs, const Functions& origin, Bundle& bundle)
  {
    Moments& moments = bundle.moments;
    moments.clear();
    bundle.sizes = {};
    Functions& at = bundle.functions_at_end;
    at = origin;
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
      const Values weight = next.middle * weight_of_length(next.gain);
      moments.add(next.middle, middle, weight);
      bundle.sizes.add(next.middle, next.gain, weight);
    });
    bundle.end = limbs.end_along_direction();
    bundle.is_complete = limbs.is_complete();
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

  Least_squares_fit<Scalar, Basis::size> solve_bundles() const
  {
    const auto equations = sum_of_bundles();
    const Scalar sum_of_weights = equations.matrix[Basis::constant][Basis::constant];
    const Scalar angle_between_limbs = Scalar(2 * CGAL_PI) / directions_.number_of_limbs;
    return solve<Basis::fitted, Basis::isotropic>(
      equations, sum_of_sizes().independent_values(sum_of_weights, angle_between_limbs), [](const auto& neglected) {
        return predicted_share(neglected, Basis::expected_square(neglected.plain));
      });
  }

  Sample_sizes<Scalar> sum_of_sizes() const
  {
    Sample_sizes<Scalar> sum;
    for(const Bundle& bundle : bundles_)
      sum += bundle.sizes;
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
    // Directions are those of the plain fit: for them, what taking the neglected terms' effect back adds of noise is more
    // than the bias that it takes.
    const auto &c = field.coefficients, &plain = field.plain;
    const Scalar bending = std::hypot(plain[Basis::difference], plain[Basis::mixed]);
    const Scalar bends_as_plain = c[Basis::difference] * plain[Basis::difference] + c[Basis::mixed] * plain[Basis::mixed];
    const Scalar ratio = has_directions && bending > 0 ? std::max(bends_as_plain, Scalar(0)) / (bending * bending) : 0;
    const Scalar difference = ratio * plain[Basis::difference], mixed = ratio * plain[Basis::mixed];
    Spider_fit<Scalar> fit = principal_curvatures_of_graph<Scalar>(
      c[Basis::x_term], c[Basis::y_term], 2 * (c[Basis::isotropic] + difference), 2 * mixed,
      2 * (c[Basis::isotropic] - difference));
    fit.is_whole = has_directions || is_flat;
    fit.residual = field.residual;
    fit.independent_values = field.independent_values;
    fit.standard_error = 2 * field.standard_error;
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
