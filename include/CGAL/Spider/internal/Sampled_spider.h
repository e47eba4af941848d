// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SAMPLED_SPIDER_H
#define CGAL_SPIDER_INTERNAL_SAMPLED_SPIDER_H

#include <CGAL/Spider/internal/Limb_bundle.h>
#include <CGAL/Spider/internal/Limb_directions.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Reached_area.h>
#include <CGAL/Spider/internal/Site.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/Spider_samples.h>
#include <CGAL/Spider/internal/Star.h>
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
    directions_.set(options.number_of_directions_at(radius));
    const std::size_t number_of_bundles = directions_.cosines.size();
    shares_.resize(radii.size());
    samples_.resize(radii.size());
    areas_.assign(radii.size(), Reached_area<Scalar>());
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
                              directions_.limbs_in_bundle(i), options.limb_rule.measure);
      sample(limbs, i, origin);
    }
  }

  /// The samples up to the `k`-th radius, what that is as a share of the largest, and what was reached within it.
  Spider_samples<Scalar, Degree>& samples(std::size_t k) { return samples_[k]; }
  const Spider_extent<Scalar>& extent(std::size_t k) const { return samples_[k].extent; }
  const Reached_area<Scalar>& area(std::size_t k) const { return areas_[k]; }
  Scalar share_of_radius(std::size_t k) const { return shares_[k]; }

  Normal_equations<Scalar, Basis::size> equations(std::size_t k) const { return samples_[k].equations(directions_); }

  /// returns in how many values the noise in these equations is independent.
  Scalar independent_values(std::size_t k, const Normal_equations<Scalar, Basis::size>& equations) const
  {
    const Scalar sum_of_weights = equations.matrix[Basis::constant][Basis::constant];
    const Scalar angle_between_limbs = Scalar(2 * CGAL_PI) / directions_.number_of_limbs;
    return samples_[k].sizes().independent_values(sum_of_weights, angle_between_limbs);
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
        const Limb_end end = limbs.end(lane);
        samples.end_lane(lane, limbs.end_along_direction()[lane], end == radius_reached);
        if(lane >= number_of_limbs)
          return;
        const Scalar reached = limbs.reached(lane) / shares_[k];
        samples_[k].extent.add(reached, end, limbs.climbs(lane));
        areas_[k].add(reached, end, directions_.cosines[bundle][lane], directions_.sines[bundle][lane]);
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

  Limb_directions<Scalar> directions_;
  std::vector<Scalar> shares_;                          ///< of the largest radius
  std::vector<Spider_samples<Scalar, Degree>> samples_; ///< for each radius
  std::vector<Reached_area<Scalar>> areas_;             ///< for each radius
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SAMPLED_SPIDER_H
