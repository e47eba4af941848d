// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SPIDER_ENGINE_H
#define CGAL_SPIDER_INTERNAL_SPIDER_ENGINE_H

#include <CGAL/Spider/internal/Estimate_blend.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Spider_fit.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/section_fit.h>
#include <CGAL/Spider/internal/surface_fit.h>

#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// The spider at one point after another: limbs, fit, and again from the new normal (paper, 2.2 to 2.4). Keeps its
/// buffers, so every thread has its own.
template <typename View, typename Fit>
class Spider_engine
{
  using Scalar = typename View::Scalar;

public:
  Spider_engine(const View& view, const Options<Scalar>& options) : view_(view), options_(options), fit_(options) {}

  Estimate<Scalar> operator()(const Site<View>& site, Scalar radius, const Vec3<Scalar>& first_normal)
  {
    Estimate<Scalar> estimate;
    if(site.rim.empty())
      return estimate;
    estimate.status = insufficient;
    estimate.normal = first_normal;
    if(radius > 0 && std::isfinite(radius) && first_normal.allFinite())
      iterate(site, radius, first_normal, options_.number_of_iterations, estimate);
    return estimate;
  }

  /// estimates at one point with each of several radii, in ascending order. `surface_fit` walks limbs once for all, in
  /// the frame of the first normal. Radii for which that isn't the last round, or whose limbs climb walls, go on one by
  /// one.
  void operator()(const Site<View>& site, const std::vector<Scalar>& radii, const Vec3<Scalar>& first_normal,
                  std::vector<Estimate<Scalar>>& estimates)
  {
    estimates.assign(radii.size(), Estimate<Scalar>());
    if constexpr(Fit::walks_once_for_all_radii)
      if(!site.rim.empty() && !site.is_elongated() && first_normal.allFinite())
        estimate_in_one_walk(site, radii, first_normal, estimates);
    for(std::size_t k = 0; k < radii.size(); ++k)
    {
      if(!estimates[k].has_fit())
        estimates[k] = (*this)(site, radii[k], first_normal);
      else
        iterate(site, radii[k], first_normal, options_.number_of_iterations - 1, estimates[k]);
    }
  }

private:
  /// grows spiders from the normal of an estimate and from those that they lead to. If the estimate has a fit already,
  /// that is of a spider with the given normal.
  void iterate(const Site<View>& site, Scalar radius, Vec3<Scalar> normal, int number_of_rounds,
               Estimate<Scalar>& estimate)
  {
    Scalar reach = radius; // of this spider: less than the radius where that leads over walls
    Estimate_blend<Scalar> rounds;
    Spider_frame<Scalar> frame(normal, site.reference);
    for(int round = 0; round < number_of_rounds; ++round)
    {
      Scalar share = estimate.has_fit() ? share_of_next_round(normal, estimate.normal) : Scalar(1);
      if(share == 0)
        break;
      normal = estimate.normal;
      if(estimate.has_fit()) // the paper's directions are counted from the reference in each round
        frame = Fit::rests_at_best_fit ? frame.turned_to(normal) : Spider_frame<Scalar>(normal, site.reference);
      Spider_extent<Scalar> extent;
      const Spider_fit<Scalar> fit = fit_within_walls(site, frame, reach, extent);
      const Scalar coverage = extent.coverage() * (reach / radius);
      if(!estimate.has_fit())
        estimate.coverage = coverage;
      if(!fit.determined)
        break; // the last round's answer stays
      if(Fit::rests_at_best_fit && estimate.has_fit())
      {
        // A spider that saw half as much must fit twice as well.
        const Scalar misfit = fit.residual * reach * estimate.coverage, last_misfit = estimate.residual * coverage;
        share *= share_of_better_fit(misfit / last_misfit);
        if(share == 0)
          break;
        rounds.add(estimate, 1 - share);
      }
      take(fit, extent, frame, reach, estimate);
      estimate.coverage = coverage;
      if(reach < radius)
        estimate.status = partial;
    }
    estimate = rounds.completed_by(estimate);
  }

  /// returns which share of the answer the next round gets, given the normals of the last round's spider and of its
  /// fit: nothing if the normal hardly moved, all if it moved clearly. `surface_fit`'s rounds come in little by little
  /// in between, lest answers jump where the next vertex takes one more round.
  Scalar share_of_next_round(const Vec3<Scalar>& normal, const Vec3<Scalar>& found) const
  {
    // Measured on paths over a noisy scan: at 4/3, answers jump twice as often by a twentieth of what they vary by.
    constexpr Scalar clearly = Fit::rests_at_best_fit ? Scalar(2) : Scalar(1);
    const Scalar least = options_.convergence_angle;
    return 1 - falling(angle_between(normal, found), least, clearly * least);
  }

  /// returns which share of that the next round keeps, given its misfit by the last one's: all if it fits clearly
  /// better, nothing if it fits clearly worse.
  static Scalar share_of_better_fit(Scalar ratio_of_misfits)
  {
    constexpr Scalar clearly_better = Scalar(0.5), clearly_worse = Scalar(1.2);
    return falling(ratio_of_misfits, clearly_better, clearly_worse);
  }

  /// leaves those without a fit that limbs climbing walls spoil.
  void estimate_in_one_walk(const Site<View>& site, const std::vector<Scalar>& radii, const Vec3<Scalar>& first_normal,
                            std::vector<Estimate<Scalar>>& estimates)
  {
    const Spider_frame<Scalar> frame(first_normal, site.reference);
    fit_.grow(view_, site, frame, radii);
    for(std::size_t k = 0; k < radii.size(); ++k)
    {
      const Spider_extent<Scalar>& extent = fit_.extent(k);
      const Spider_fit<Scalar> fit =
        extent.is_walled_in() ? Spider_fit<Scalar>() : fit_.fit(view_, site, frame, radii[k], k);
      if(fit.determined)
        take(fit, extent, frame, radii.back(), estimates[k]);
    }
  }

  /// grows a spider and fits it. Where most limbs climb walls, the surface is smaller than the reach, as a sphere may
  /// be: there the spider is grown again with half of it, and half of that.
  Spider_fit<Scalar> fit_within_walls(const Site<View>& site, const Spider_frame<Scalar>& frame, Scalar& reach,
                                      Spider_extent<Scalar>& extent)
  {
    constexpr int most_halvings = 6;
    // Were it noise that limbs climb, the misfit would be as large at any reach; but where few vertices are, anything
    // fits.
    constexpr Scalar same_misfit = Scalar(0.25);
    constexpr Scalar fewest_values = 12; // twice as many as a quadric has terms
    const Spider_fit<Scalar> fit = fit_(view_, site, frame, reach, extent);
    bool is_walled_in = extent.is_walled_in();
    Scalar smaller_reach = reach;
    for(int i = 0; i < most_halvings && is_walled_in; ++i)
    {
      smaller_reach /= 2;
      Spider_extent<Scalar> smaller_extent;
      const Spider_fit<Scalar> smaller_fit = fit_(view_, site, frame, smaller_reach, smaller_extent);
      is_walled_in = smaller_extent.is_walled_in();
      if(!is_walled_in && smaller_fit.determined && smaller_fit.independent_values >= fewest_values &&
         !(smaller_fit.residual * smaller_reach > same_misfit * fit.residual * reach))
      {
        reach = smaller_reach;
        extent = smaller_extent;
        return smaller_fit;
      }
    }
    // Limbs that climb all around, and get nowhere, see noise or a fold from the side.
    constexpr Scalar least_reached = Scalar(0.125);
    const bool gets_nowhere = extent.is_walled_in() && extent.reached < least_reached * Scalar(extent.number_of_limbs);
    return gets_nowhere ? Spider_fit<Scalar>() : fit;
  }

  /// has an estimate be that of a fit in units of the given length.
  static void take(const Spider_fit<Scalar>& fit, const Spider_extent<Scalar>& extent,
                   const Spider_frame<Scalar>& frame, Scalar unit_length, Estimate<Scalar>& estimate)
  {
    const auto from_frame = [&](const Vec3<Scalar>& a) -> Vec3<Scalar> {
      return a.x() * frame.tangent + a.y() * frame.bitangent + a.z() * frame.normal;
    };
    estimate.status = extent.is_complete && fit.is_whole ? ok : partial;
    estimate.coverage = extent.coverage();
    estimate.meets_border = extent.meets_border;
    estimate.min_curvature = fit.min_curvature / unit_length;
    estimate.max_curvature = fit.max_curvature / unit_length;
    estimate.residual = fit.residual * unit_length;
    estimate.standard_error = fit.standard_error / unit_length;
    estimate.normal = unit<Scalar>(from_frame(fit.normal));
    estimate.min_direction = unit<Scalar>(from_frame(fit.min_direction));
    estimate.max_direction = estimate.normal.cross(estimate.min_direction);
  }

  const View& view_;
  const Options<Scalar>& options_;
  Fit fit_;
};

/// The engine of the estimator that the options name.
template <typename View>
class Estimator_engine
{
  using Scalar = typename View::Scalar;

public:
  Estimator_engine(const View& view, const Options<Scalar>& options) : engine_(make(view, options)) {}

  Estimate<Scalar> operator()(const Site<View>& site, Scalar radius, const Vec3<Scalar>& first_normal)
  {
    return std::visit([&](auto& engine) { return engine(site, radius, first_normal); }, engine_);
  }

  void operator()(const Site<View>& site, const std::vector<Scalar>& radii, const Vec3<Scalar>& first_normal,
                  std::vector<Estimate<Scalar>>& estimates)
  {
    std::visit([&](auto& engine) { engine(site, radii, first_normal, estimates); }, engine_);
  }

private:
  template <typename Fit>
  using Of = Spider_engine<View, Fit>;
  using Engine =
    std::variant<Of<Section_fit<View>>, Of<Surface_fit<View, 2>>, Of<Surface_fit<View, 3>>, Of<Surface_fit<View, 4>>>;

  static Engine make(const View& view, const Options<Scalar>& options)
  {
    if(options.estimator == section_fit)
      return Of<Section_fit<View>>(view, options);
    switch(options.polynomial_degree)
    {
      case 2: return Of<Surface_fit<View, 2>>(view, options);
      case 3: return Of<Surface_fit<View, 3>>(view, options);
      default: return Of<Surface_fit<View, 4>>(view, options);
    }
  }

  Engine engine_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SPIDER_ENGINE_H
