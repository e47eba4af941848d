// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SAMPLED_SPIDER_H
#define CGAL_SPIDER_INTERNAL_SAMPLED_SPIDER_H

#include <CGAL/Spider/internal/Height_field_fit.h>
#include <CGAL/Spider/internal/Limb_bundle.h>
#include <CGAL/Spider/internal/Limb_directions.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Reached_area.h>
#include <CGAL/Spider/internal/Site.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/Spider_samples.h>
#include <CGAL/Spider/internal/Star.h>
#include <CGAL/Spider/internal/elongation.h>
#include <CGAL/Spider/internal/height_field.h>
#include <CGAL/Spider/internal/least_squares.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// The spider of `surface_fit` and the samples of its limbs, for a height field of the given degree, up to each of
/// several radii. Lengths are in units of the largest one. Keeps its buffers from one query to the next.
template <typename View, int Degree>
class Sampled_spider
{
  using Scalar = typename View::Scalar;
  using Basis = Height_field_basis<Degree>;
  using Functions = typename Bundle_samples<Scalar, Degree>::Functions;

public:
  /// grows a spider to radii in ascending order, in one walk.
  void grow(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame,
            const std::vector<Scalar>& radii, const Options<Scalar>& options)
  {
    const Scalar radius = radii.back();
    shares_.resize(radii.size());
    for(std::size_t k = 0; k < radii.size(); ++k)
      shares_[k] = radii[k] / radius;
    grow_bundles(view, site, frame, radius, options, [this](Limb_bundle<View>& limbs, std::size_t bundle) {
      // Samples up to the largest radius are added up, those up to smaller ones are what there is when a limb comes by.
      auto& all = samples_.back().bundles[bundle];
      limbs.walk(
        shares_, [&](const Segments<Scalar>& next) { all.add(next, samples_.back().short_length); },
        [&](int lane, std::size_t k) {
          auto& samples = samples_[k].bundles[bundle];
          if(&samples != &all)
            samples.take_lane(lane, all);
          note_end(limbs, bundle, lane, k, 1);
        });
    });
  }

  /// grows a spider that is shorter across its site's long axis.
  void grow_in_ellipse(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame, Scalar radius,
                       const Options<Scalar>& options)
  {
    grow_within(view, site, frame, radius, options, [&](const Lanes<Scalar>& cosines, const Lanes<Scalar>& sines) {
      return shares_reached(site.shortening, frame, cosines, sines);
    });
  }

  /// grows a spider that stays within the radius of a point in its local coordinates.
  void grow_in_disc(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame, Scalar radius,
                    Scalar x, Scalar y, const Options<Scalar>& options)
  {
    // up to where the limbs' directions meet the unit circle around the point
    grow_within(view, site, frame, radius, options, [&](const Lanes<Scalar>& cosines, const Lanes<Scalar>& sines) {
      const Lanes<Scalar> along = cosines * Lanes<Scalar>(x) + sines * Lanes<Scalar>(y);
      const Lanes<Scalar> zero(0), squared = along * along + Lanes<Scalar>(1 - x * x - y * y);
      return larger(along + square_root(larger(squared, zero)), zero);
    });
  }

  /// What the `k`-th radius is as a share of the largest, and what was reached within it.
  Scalar share_of_radius(std::size_t k) const { return shares_[k]; }
  const Spider_extent<Scalar>& extent(std::size_t k) const { return samples_[k].extent; }
  const Reached_area<Scalar>& area(std::size_t k) const { return areas_[k]; }

  /// fits the samples up to the `k`-th radius, once.
  Height_field_fit<Degree, Scalar> fit(std::size_t k)
  {
    // Limbs' ends have their weight against noise. Higher degrees are for meshes without: where what a quadric neglects
    // matters more than noise does, that weight is withdrawn, and errors are a quarter smaller.
    const Scalar share = Degree == 2 ? Scalar(1) : height_field(k).share_of_noise();
    samples_[k].add_ends(share);
    return height_field(k);
  }

private:
  /// grows a spider whose limbs reach what `reach_of(cosines, sines)` returns, in units of the radius.
  template <typename ReachOf>
  void grow_within(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame, Scalar radius,
                   const Options<Scalar>& options, const ReachOf& reach_of)
  {
    shares_.assign(1, 1);
    grow_bundles(view, site, frame, radius, options, [&](Limb_bundle<View>& limbs, std::size_t bundle) {
      auto& all = samples_.back().bundles[bundle];
      const Lanes<Scalar> reach = reach_of(directions_.cosines[bundle], directions_.sines[bundle]);
      limbs.walk_each(reach, [&](const Segments<Scalar>& next) { all.add(next, samples_.back().short_length); });
      for(int l = 0; l < number_of_lanes; ++l)
        note_end(limbs, bundle, l, 0, reach[l]);
    });
  }

  /// fits the samples that there are.
  Height_field_fit<Degree, Scalar> height_field(std::size_t k) const
  {
    const auto equations = samples_[k].equations(directions_);
    const Scalar sum_of_weights = equations.products[Basis::constant][Basis::constant];
    const Scalar angle_between_limbs = Scalar(2 * CGAL_PI) / directions_.number_of_limbs;
    return {equations, samples_[k].sizes().independent_values(sum_of_weights, angle_between_limbs)};
  }

  /// calls `walk(limbs, bundle)` for all bundles of limbs.
  template <typename Walk>
  void grow_bundles(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame, Scalar radius,
                    const Options<Scalar>& options, const Walk& walk)
  {
    directions_.set(options.number_of_directions_at(radius));
    const std::size_t number_of_bundles = directions_.cosines.size();
    samples_.resize(shares_.size());
    areas_.assign(shares_.size(), Reached_area<Scalar>());
    for(std::size_t k = 0; k < shares_.size(); ++k)
      samples_[k].begin(number_of_bundles, shares_[k], short_segment * shares_.front());

    const Star<View> star(view, site, Local_coordinates<Scalar>(site.point, frame, radius));
    const Functions origin = functions_at_origin(view, site, star.local);
    for(std::size_t i = 0; i < number_of_bundles; ++i)
    {
      Limb_bundle<View> limbs(view, site, star, directions_.cosines[i], directions_.sines[i],
                              directions_.limbs_in_bundle(i), options.limb_rule.measure);
      samples_.back().bundles[i].clear(origin);
      walk(limbs, i);
    }
  }

  /// notes where a limb ended that was to reach a share of the `k`-th radius.
  void note_end(const Limb_bundle<View>& limbs, std::size_t bundle, int lane, std::size_t k, Scalar to_reach)
  {
    const Limb_end end = limbs.end(lane);
    samples_[k].bundles[bundle].set_reach(lane, to_reach * shares_[k]);
    if(lane >= directions_.limbs_in_bundle(bundle))
      return;
    const Scalar reached = limbs.reached(lane) / shares_[k];
    samples_[k].extent.add(to_reach > 0 ? reached / to_reach : Scalar(0), end, limbs.climbs(lane));
    areas_[k].add(reached, to_reach, end, directions_.cosines[bundle][lane], directions_.sines[bundle][lane]);
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

  Limb_directions<Scalar> directions_;
  std::vector<Scalar> shares_;                          ///< of the largest radius
  std::vector<Spider_samples<Scalar, Degree>> samples_; ///< for each radius
  std::vector<Reached_area<Scalar>> areas_;             ///< for each radius
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SAMPLED_SPIDER_H
