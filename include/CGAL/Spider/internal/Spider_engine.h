// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SPIDER_ENGINE_H
#define CGAL_SPIDER_INTERNAL_SPIDER_ENGINE_H

#include <CGAL/Spider/Curvature_estimate_3.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Samples.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/section_fit.h>

#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// `Curvature_estimate_3` on plain numbers.
template <typename Scalar>
struct Estimate
{
  Scalar min_curvature = nan<Scalar>(), max_curvature = nan<Scalar>();
  Vec3<Scalar> min_direction = nan_vec3<Scalar>(), max_direction = nan_vec3<Scalar>(), normal = nan_vec3<Scalar>();
  Estimate_status status = isolated;
  Scalar coverage = 0;
  Scalar residual = nan<Scalar>();
};

/// The samples of both limbs of a direction, and how far these got.
template <typename Scalar>
struct Direction_samples
{
  std::vector<Sample<Scalar>> samples;
  Scalar length = 0;         ///< of both limbs, in units of the radius
  bool is_complete = false;  ///< both limbs reached the radius
};

/// walks the two limbs of a direction.
template <typename View>
void sample_direction(const View& view,
                      const Site<View>& site,
                      const Vec3<typename View::Scalar>& direction,
                      const Vec3<typename View::Scalar>& normal,
                      typename View::Scalar radius,
                      typename View::Scalar resampling_step,
                      Direction_samples<typename View::Scalar>& out)
{
  using Scalar = typename View::Scalar;
  out.samples.clear();
  const Walk_result<View> forth =
    sample_limb(view, site, Cut<Scalar>(site.point, direction, normal, radius), resampling_step, 1, out.samples);
  const Walk_result<View> back = sample_limb(
    view, site, Cut<Scalar>(site.point, Vec3<Scalar>(-direction), normal, radius), resampling_step, -1, out.samples);
  out.length = forth.length + back.length;
  out.is_complete = forth.end == radius_reached && back.end == radius_reached;
}

/// The spider at one point after another: limbs, sections, principal pair, and again from the new normal
/// (paper, 2.2 to 2.4). Keeps its buffers, so every thread has its own.
template <typename View>
class Spider_engine
{
  using Scalar = typename View::Scalar;

public:
  Spider_engine(const View& view, const Options<Scalar>& options)
    : view_(view), options_(options), sections_(options.number_of_directions)
  {
  }

  Estimate<Scalar> operator()(const Site<View>& site, Scalar radius, const Vec3<Scalar>& first_normal)
  {
    Estimate<Scalar> estimate;
    if(site.rim.empty())
      return estimate;
    estimate.status = insufficient;
    estimate.normal = first_normal;
    if(!(radius > 0) || !std::isfinite(radius) || !first_normal.allFinite())
      return estimate;

    for(int round = 0; round < options_.number_of_iterations; ++round)
    {
      const Spider_frame<Scalar> frame(estimate.normal, site.reference);
      const Spider_fit<Scalar> fit = fit_spider(site, frame, radius, estimate);
      if(!fit.determined)
        break;
      const Vec3<Scalar> previous = estimate.normal;
      take(fit, frame, radius, estimate);
      if(angle_between(previous, estimate.normal) <= options_.convergence_angle)
        break;
    }
    return estimate;
  }

private:
  /// grows a spider; notes its coverage in `estimate`, and whether that is all.
  Spider_fit<Scalar>
  fit_spider(const Site<View>& site, const Spider_frame<Scalar>& frame, Scalar radius, Estimate<Scalar>& estimate)
  {
    const int count = options_.number_of_directions;
    Scalar length = 0;
    bool is_complete = true;
    for(int i = 0; i < count; ++i)
    {
      const Vec3<Scalar> direction = frame.direction(angle_of_direction<Scalar>(i, count));
      sample_direction(view_, site, direction, frame.normal, radius, options_.resampling_step, samples_);
      sections_[i] = fit_section(samples_.samples, options_.polynomial_degree);
      length += samples_.length;
      is_complete = is_complete && samples_.is_complete;
    }
    const Spider_fit<Scalar> fit = fit_principal_pair(sections_);
    if(fit.determined || estimate.status == insufficient) // a later round that fails leaves the last one's answer
      estimate.coverage = length / (2 * count);
    if(fit.determined)
      estimate.status = is_complete ? ok : partial;
    return fit;
  }

  static void
  take(const Spider_fit<Scalar>& fit, const Spider_frame<Scalar>& frame, Scalar radius, Estimate<Scalar>& estimate)
  {
    estimate.min_curvature = fit.min_curvature / radius;
    estimate.max_curvature = fit.max_curvature / radius;
    estimate.residual = fit.residual * radius;
    estimate.normal =
      unit<Scalar>(fit.normal.x() * frame.tangent + fit.normal.y() * frame.bitangent + fit.normal.z() * frame.normal);
    // The pair is orthogonal to the normal that it was found with; it is turned to be so to the new one.
    const Vec3<Scalar> direction = frame.direction(fit.min_angle);
    estimate.min_direction = unit<Scalar>(direction - direction.dot(estimate.normal) * estimate.normal);
    estimate.max_direction = estimate.normal.cross(estimate.min_direction);
  }

  const View& view_;
  Options<Scalar> options_;
  Direction_samples<Scalar> samples_;
  std::vector<Section<Scalar>> sections_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SPIDER_ENGINE_H
