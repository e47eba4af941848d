// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The estimator that Spider adds to the paper's: one height field z(x, y) fitted to samples of all limbs at once.
//
// - It needn't pass through the query point, which is as noisy as any other, and its gradient is free: curvatures come
//   from its fundamental forms, so the frame may be tilted.
// - Samples stand for area, and are compared with the mesh that the height field would give (Bundle_samples.h).
// - A quadric takes what quartic terms do to the rim for curvature. So terms up to the fourth degree are fitted too, as
//   far as noise lets (Height_field_fit.h).
// - At borders and feature edges, where the surface ends on one side, more terms are fitted (One_sided_fit.h).
// - Limbs are walked in lockstep, and their samples only leave sums of powers behind.

#ifndef CGAL_SPIDER_INTERNAL_SURFACE_FIT_H
#define CGAL_SPIDER_INTERNAL_SURFACE_FIT_H

#include <CGAL/Spider/internal/One_sided_fit.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Sampled_spider.h>
#include <CGAL/Spider/internal/Spider_fit.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/height_field.h>

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

  /// grows a spider to several radii in ascending order, in one walk; one that is elongated, to a single radius. What
  /// there is at each, `fit()` and `extent()` tell.
  void grow(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame,
            const std::vector<Scalar>& radii)
  {
    if(site.is_elongated())
      spider_.grow_in_ellipse(view, site, frame, radii.front(), options_);
    else
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
    const Height_field_fit<Degree, Scalar> fit = spider_.fit(k);
    const Local_field<Scalar> field = fit.at(0, 0);
    return field.determined ? field : fit.plain(extent(k).is_complete);
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
