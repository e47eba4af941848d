// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The estimator that Spider adds to the paper's: one height field z(x, y) fitted to samples of all limbs at once.
//
// - It needn't pass through the query point, which is as noisy as any other, and its gradient is free: curvatures come
//   from its fundamental forms, so the frame may be tilted.
// - Samples stand for area, and are compared with the mesh that the height field would give (Spider_samples.h).
// - A quadric takes what quartic terms do to the rim for curvature. These terms are estimated too, and their effect is
//   taken back by a share: the larger curvature lets expect them to be, and the less noise there is, the more of it.
// - Limbs are walked in lockstep, and their samples only leave sums of powers behind.

#ifndef CGAL_SPIDER_INTERNAL_SURFACE_FIT_H
#define CGAL_SPIDER_INTERNAL_SURFACE_FIT_H

#include <CGAL/Spider/internal/Limb_bundle.h>
#include <CGAL/Spider/internal/Limb_directions.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Spider_fit.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/Spider_samples.h>
#include <CGAL/Spider/internal/Star.h>
#include <CGAL/Spider/internal/height_field.h>
#include <CGAL/Spider/internal/least_squares.h>

#include <algorithm>
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
  using Samples = Spider_samples<Scalar, Degree>;
  using Functions = typename Bundle_samples<Scalar, Degree>::Functions;

public:
  /// A surface that isn't a height field, such as that around a sharp ridge, has several normals from which the next
  /// round leads elsewhere: the iteration rests when the fit doesn't get better.
  static constexpr bool rests_at_best_fit = true;
  static constexpr bool walks_once_for_all_radii = true;

  explicit Surface_fit(const Options<Scalar>& options) : options_(options) {}

  /// grows a spider and fits it.
  Spider_fit<Scalar> operator()(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame,
                                Scalar radius, Spider_extent<Scalar>& extent)
  {
    radius_.assign(1, radius);
    grow(view, site, frame, radius_);
    extent = this->extent(0);
    return fit(0);
  }

  /// grows a spider to several radii in ascending order, in one walk. What there is at each, `fit()` and `extent()`
  /// tell.
  void grow(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame,
            const std::vector<Scalar>& radii)
  {
    const Scalar radius = radii.back();
    directions_.set(options_.number_of_directions_at(radius));
    const std::size_t number_of_bundles = directions_.cosines.size();
    shares_.resize(radii.size());
    samples_.resize(radii.size());
    for(std::size_t k = 0; k < radii.size(); ++k)
    {
      shares_[k] = radii[k] / radius;
      samples_[k].begin(number_of_bundles, shares_[k], short_segment * radii.front() / radius);
    }

    const Star<View> star(view, site, Local_coordinates<Scalar>(site.point, frame, radius));
    const Functions origin = functions_at_origin(view, site, star.local);
    for(std::size_t i = 0; i < number_of_bundles; ++i)
    {
      Limb_bundle<View> limbs(view, site, star, directions_.cosines[i], directions_.sines[i],
                              directions_.limbs_in_bundle(i), options_.limb_rule.measure);
      sample(limbs, i, origin);
    }
  }

  /// returns how far the spider got that was grown to the `k`-th radius, in units of that.
  const Spider_extent<Scalar>& extent(std::size_t k) const { return samples_[k].extent; }

  /// fits that spider, once, in units of the largest radius.
  Spider_fit<Scalar> fit(std::size_t k)
  {
    Samples& samples = samples_[k];
    if(!(samples.extent.reached > 0))
      return {};

    // Weight on the rim is against noise. Where neglected terms matter more than noise does, it is withdrawn.
    const auto without_rim = solve_samples(samples);
    samples.add_rim(1 - without_rim.share_of_neglected);
    return fit(solve_samples(samples), samples.extent.is_complete);
  }

private:
  /// walks the limbs of a bundle. Their samples up to the largest radius are added up, and those up to smaller ones are
  /// what there is when a limb comes by.
  void sample(Limb_bundle<View>& limbs, std::size_t bundle, const Functions& origin)
  {
    const int number_of_limbs = directions_.limbs_in_bundle(bundle);
    auto& all = samples_.back().bundles[bundle];
    all.clear(origin);
    limbs.walk(
      shares_, [&](const Segments<Scalar>& next) { all.add(next, samples_.back().short_length); },
      [&](int lane, std::size_t k) {
        auto& samples = samples_[k].bundles[bundle];
        if(&samples != &all)
          samples.take_lane(lane, all);
        samples.end_lane(lane, limbs.end_along_direction()[lane], limbs.end(lane) == radius_reached);
        if(lane < number_of_limbs)
          samples_[k].extent.add(limbs.reached(lane) / shares_[k], limbs.end(lane), limbs.climbs(lane));
      });
  }

  static constexpr Scalar short_segment = Scalar(0.01); ///< a hundredth of the radius, see `weight_by_area()`

  /// returns the terms at the query point, interpolated from the vertices that it lies between, and its height, 0.
  static Functions functions_at_origin(const View& view, const Site<View>& site, const Local_coordinates<Scalar>& local)
  {
    Functions functions;
    functions.fill(Lanes<Scalar>(0));
    for(int i = 0; i < 3; ++i)
    {
      if(!(site.weights[i] > 0))
        continue;
      const Vec3<Scalar> a = local(view.point(site.vertices[i]));
      const auto at_vertex = Basis::curved_at(a.x(), a.y());
      for(int k = 0; k < Basis::curved; ++k)
        functions[k] += Lanes<Scalar>(site.weights[i] * at_vertex[k]);
    }
    return functions;
  }

  Least_squares_fit<Scalar, Basis::size> solve_samples(const Samples& samples) const
  {
    const auto equations = samples.equations(directions_);
    const Scalar sum_of_weights = equations.matrix[Basis::constant][Basis::constant];
    const Scalar angle_between_limbs = Scalar(2 * CGAL_PI) / directions_.number_of_limbs;
    return solve<Basis::fitted, Basis::isotropic>(
      equations, samples.sizes().independent_values(sum_of_weights, angle_between_limbs),
      [](const auto& neglected) { return predicted_share(neglected, Basis::expected_square(neglected.plain)); });
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
    // Directions are those of the plain fit: for them, what taking the neglected terms' effect back adds of noise is
    // more than the bias that it takes.
    const auto &c = field.coefficients, &plain = field.plain;
    const Scalar bending = std::hypot(plain[Basis::difference], plain[Basis::mixed]);
    const Scalar bends_as_plain =
      c[Basis::difference] * plain[Basis::difference] + c[Basis::mixed] * plain[Basis::mixed];
    const Scalar ratio = has_directions && bending > 0 ? std::max(bends_as_plain, Scalar(0)) / (bending * bending) : 0;
    const Scalar difference = ratio * plain[Basis::difference], mixed = ratio * plain[Basis::mixed];
    Spider_fit<Scalar> fit =
      principal_curvatures_of_graph<Scalar>(c[Basis::x_term], c[Basis::y_term], 2 * (c[Basis::isotropic] + difference),
                                            2 * mixed, 2 * (c[Basis::isotropic] - difference));
    fit.is_whole = has_directions || is_flat;
    fit.residual = field.residual;
    fit.independent_values = field.independent_values;
    fit.standard_error = 2 * field.standard_error;
    return fit;
  }

  const Options<Scalar>& options_;
  Limb_directions<Scalar> directions_;
  std::vector<Scalar> radius_;   ///< where there is one
  std::vector<Scalar> shares_;   ///< of the largest radius
  std::vector<Samples> samples_; ///< for each radius
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SURFACE_FIT_H
