// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_BUILD_LIMB_H
#define CGAL_SPIDER_INTERNAL_BUILD_LIMB_H

#include <CGAL/Spider/Limb_3.h>
#include <CGAL/Spider/internal/Mesh_inputs.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/walk_limb.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace CGAL {
namespace Spider {
namespace internal {

/// A query of a one-point function, resolved: its site and its radius.
template <typename Inputs>
struct Query_point
{
  template <typename Query>
  Query_point(const Inputs& inputs, const Query& query)
    : site(site_of(inputs.view, query)), radius(inputs.radius_at(site.vertices[0]))
  {
    if constexpr(Inputs::has_radius_map())
    {
      radius = interpolate(site, [&](typename Inputs::Vertex v) { return inputs.radius_at(v); });
      check_radius(radius);
    }
  }

  Site<typename Inputs::View> site;
  typename Inputs::Scalar radius;
};

template <typename Scalar, typename Vector>
Vec3<Scalar> checked_normal(const Vector& normal)
{
  const Vec3<Scalar> given = to_vec3<Scalar>(normal), result = unit(given);
  check_parameter(result.allFinite(), "normal", given.transpose(), "give a finite vector that is not zero");
  return result;
}

/// returns the unit normal and the unit tangent of a half plane that the caller spans by two vectors.
template <typename Scalar, typename Normal, typename Direction>
std::pair<Vec3<Scalar>, Vec3<Scalar>> checked_tangent_frame(const Normal& normal, const Direction& direction)
{
  const Vec3<Scalar> n = checked_normal<Scalar>(normal), given = to_vec3<Scalar>(direction), d = unit(given);
  const Vec3<Scalar> tangential = d - d.dot(n) * n;
  constexpr Scalar least_angle = Scalar(1e-10); // to the normal; below, rounding chooses the direction
  check_parameter(tangential.norm() > least_angle, "direction", given.transpose(),
                  "give a finite vector that is not parallel to the normal");
  return {n, unit(tangential)};
}

/// walks a limb and keeps its points. `normal` and `direction` are orthonormal.
template <typename TriangleMesh, typename Inputs>
auto build_limb(const Inputs& inputs,
                const Query_point<Inputs>& query,
                const Vec3<typename Inputs::Scalar>& normal,
                const Vec3<typename Inputs::Scalar>& direction)
{
  using View = typename Inputs::View;
  using Scalar = typename Inputs::Scalar;
  using Limb = Limb_3<TriangleMesh, typename Inputs::Result_traits>;
  // Where the plane runs through a vertex the walk turns around it at a distance at the level of rounding.
  const Scalar same_point = 64 * std::numeric_limits<Scalar>::epsilon() *
                            (1 + query.site.point.template lpNorm<Eigen::Infinity>() / query.radius);

  Limb limb;
  const auto append = [&](const Vec3<Scalar>& p) {
    limb.polyline.push_back(from_vec3<typename Limb::Point_3>(p));
  };
  append(query.site.point);
  if(query.site.rim.empty() || !(query.radius > 0))
    return limb;

  Vec3<Scalar> last = query.site.point;
  Scalar length = 0, kept_length = 0;
  const Cut<Scalar> cut(Local_coordinates<Scalar>(query.site.point, {normal, direction}, query.radius), 1, 0);
  // In halves, since the difference of two numbers may be beyond all numbers; otherwise that rounds the same.
  const auto extend = [&](const Step<View>& step) {
    Vec3<Scalar> half_crossing = query.site.point / 2;
    if(step.exit != nullptr)
    {
      const Vec3<Scalar> half_source = inputs.view.point(inputs.view.source(step.exit->edge)) / 2,
                         half_target = inputs.view.point(inputs.view.target(step.exit->edge)) / 2;
      half_crossing = half_source + step.crossing * (half_target - half_source);
    }
    const Vec3<Scalar> half_way = step.share * (half_crossing - last / 2);
    last = 2 * (last / 2 + half_way);
    length += 2 * (half_way / query.radius).norm();
    if(length - kept_length <= same_point && limb.polyline.size() > 1)
      limb.polyline.back() = from_vec3<typename Limb::Point_3>(last);
    else
      append(last);
    kept_length = length;
  };
  const Walk_result<View> walk = walk_limb(inputs.view, query.site, cut, inputs.options.limb_rule, extend);
  if(inputs.options.limb_rule.measure == arc_length) // the walk cut it to the radius, but for rounding
    length = walk.end == radius_reached ? Scalar(1) : std::min(length, Scalar(1));
  limb.length = static_cast<typename Limb::FT>(length * query.radius);
  limb.end = walk.end;
  if(walk.edge != View::null_halfedge())
    limb.edge = inputs.view.edge(walk.edge);
  return limb;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_BUILD_LIMB_H
