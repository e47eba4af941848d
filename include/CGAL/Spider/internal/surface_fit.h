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
// - Of degree 3 and 4, terms above the quadratic ones are taken as far as noise lets (fit_expected_terms.h).
// - At borders and feature edges, where the surface ends on one side, more terms are fitted (One_sided_fit.h).
// - Limbs are walked in lockstep, and their samples only leave sums of powers behind.

#ifndef CGAL_SPIDER_INTERNAL_SURFACE_FIT_H
#define CGAL_SPIDER_INTERNAL_SURFACE_FIT_H

#include <CGAL/Spider/internal/One_sided_fit.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Sampled_spider.h>
#include <CGAL/Spider/internal/Spider_fit.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/fit_expected_terms.h>
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
    return fit(view, site, frame, radius, 0);
  }

  /// grows a spider to several radii in ascending order, in one walk. What there is at each, `fit()` and `extent()`
  /// tell.
  void grow(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame,
            const std::vector<Scalar>& radii)
  {
    spider_.grow(view, site, frame, radii, options_);
  }

  /// returns how far the spider got that was grown to the `k`-th radius, in units of that.
  const Spider_extent<Scalar>& extent(std::size_t k) const { return spider_.extent(k); }

  /// fits that spider, once, in units of the largest radius.
  Spider_fit<Scalar> fit(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame, Scalar radius,
                         std::size_t k)
  {
    if(!(extent(k).reached > 0))
      return {};
    Local_field<Scalar> field = two_sided_field(k);
    const Reached_area<Scalar>& area = spider_.area(k);
    const Scalar share = One_sided_fit<View>::share(area.cut_off());
    if(field.determined && share > 0)
    {
      const Local_field<Scalar> one_sided = one_sided_fit_(view, site, frame, radius, area, options_);
      if(one_sided.determined)
        field = field.towards(one_sided.in_units_of(spider_.share_of_radius(k)), share);
    }
    return fit_of(field);
  }

private:
  /// fits the spider alone.
  Local_field<Scalar> two_sided_field(std::size_t k)
  {
    if constexpr(Degree == 2)
    {
      // Weight on the rim is against noise. Where neglected terms matter more than noise does, it is withdrawn.
      const auto without_rim = solve_samples(k);
      spider_.samples(k).add_rim(1 - without_rim.share_of_neglected);
    }
    else
    {
      spider_.samples(k).add_rim(1);
      const auto equations = spider_.equations(k);
      const Local_field<Scalar> field =
        fit_expected_terms<Degree>(equations, spider_.independent_values(k, equations), Scalar(0), Scalar(0));
      if(field.determined)
        return field;
    }
    return local_field(solve_samples(k), extent(k).is_complete);
  }

  Least_squares_fit<Scalar, Basis::size> solve_samples(std::size_t k) const
  {
    const auto equations = spider_.equations(k);
    return solve<Basis::fitted, Basis::isotropic>(
      equations, spider_.independent_values(k, equations),
      [](const auto& neglected) { return predicted_share(neglected, Basis::expected_square(neglected.plain)); });
  }

  static Local_field<Scalar> local_field(const Least_squares_fit<Scalar, Basis::size>& fit, bool is_complete)
  {
    // A spider inside one face, or inside coplanar ones, sees a plane, and no more than that if it is complete.
    const auto& determined = fit.determined;
    const bool is_flat = is_complete && !determined[Basis::isotropic];
    if(!determined[Basis::constant] || !determined[Basis::x_term] || !determined[Basis::y_term] ||
       !(determined[Basis::isotropic] || is_flat))
      return {};
    // Few vertices, or few limbs, may tell how much the surface bends but not in which direction it does so more.
    const bool has_directions = determined[Basis::difference] && determined[Basis::mixed] && !is_flat;
    // Directions are those of the plain fit: for them, what taking the neglected terms' effect back adds of noise is
    // more than the bias that it takes.
    const auto &c = fit.coefficients, &plain = fit.plain;
    const Scalar bending = std::hypot(plain[Basis::difference], plain[Basis::mixed]);
    const Scalar bends_as_plain =
      c[Basis::difference] * plain[Basis::difference] + c[Basis::mixed] * plain[Basis::mixed];
    const Scalar ratio = has_directions && bending > 0 ? std::max(bends_as_plain, Scalar(0)) / (bending * bending) : 0;
    const Scalar difference = ratio * plain[Basis::difference], mixed = ratio * plain[Basis::mixed];
    Local_field<Scalar> field;
    field.determined = true;
    field.is_whole = has_directions || is_flat;
    field.derivatives = {c[Basis::x_term], c[Basis::y_term], 2 * (c[Basis::isotropic] + difference), 2 * mixed,
                         2 * (c[Basis::isotropic] - difference)};
    field.residual = fit.residual;
    field.independent_values = fit.independent_values;
    field.standard_error = 2 * fit.standard_error;
    return field;
  }

  static Spider_fit<Scalar> fit_of(const Local_field<Scalar>& field)
  {
    if(!field.determined)
      return {};
    Spider_fit<Scalar> fit = principal_curvatures_of_graph(field.derivatives);
    fit.is_whole = field.is_whole;
    fit.residual = field.residual;
    fit.independent_values = field.independent_values;
    fit.standard_error = field.standard_error;
    return fit;
  }

  const Options<Scalar>& options_;
  Sampled_spider<View, Degree> spider_;
  One_sided_fit<View> one_sided_fit_;
  std::vector<Scalar> radius_; ///< where there is one
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SURFACE_FIT_H
