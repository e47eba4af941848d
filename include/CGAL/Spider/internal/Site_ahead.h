// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SITE_AHEAD_H
#define CGAL_SPIDER_INTERNAL_SITE_AHEAD_H

#include <CGAL/Spider/internal/Limb_rule.h>
#include <CGAL/Spider/internal/Local_coordinates.h>
#include <CGAL/Spider/internal/Site.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/walk_limb.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns the site at a point of a face, given one of the face's edges. Areas are in units of the square of
/// `unit_length`.
template <typename View>
Site<View> site_at_point(const View& view, typename View::Halfedge edge, const Vec3<typename View::Scalar>& point,
                         typename View::Scalar unit_length)
{
  using Scalar = typename View::Scalar;
  const auto face = view.face(edge);
  const typename View::Halfedge first = view.halfedge(face);
  const auto [second, third] = view.other_edges(first);
  const auto from_point = [&](typename View::Halfedge h) -> Vec3<Scalar> {
    return (view.point(view.source(h)) - point) / unit_length;
  };
  const Vec3<Scalar> a = from_point(first), b = from_point(second), c = from_point(third);
  const Vec3<Scalar> normal = (b - a).cross(c - a);
  const auto part = [&](const Vec3<Scalar>& u, const Vec3<Scalar>& v) {
    return std::max(u.cross(v).dot(normal), Scalar(0));
  };
  std::array<Scalar, 3> weights = {part(b, c), part(c, a), part(a, b)};
  const Scalar sum = weights[0] + weights[1] + weights[2];
  if(!(sum > 0) || !std::isfinite(sum)) // a face without area: one of its corners is as near as any other point
    weights = {1, 0, 0};
  else
    for(Scalar& weight : weights)
      weight /= sum;
  return site_at_location(view, face, weights);
}

/// A place on the mesh, and which share of the way was walked that was to lead there.
template <typename View>
struct Way_end
{
  Site<View> site;
  typename View::Scalar reached;
};

/// walks straight ahead on a surface, as a limb does, and up to a border or a feature edge at most.
template <typename View>
Way_end<View> walk_ahead(const View& view, const Site<View>& site, const Spider_frame<typename View::Scalar>& frame,
                         typename View::Scalar cosine, typename View::Scalar sine, typename View::Scalar distance)
{
  using Scalar = typename View::Scalar;
  Limb_rule<Scalar> rule(tangential_distance);
  rule.sine_of_minimum_crossing_angle = 0; // limbs in lockstep stop at feature edges at any angle, too
  const Cut<Scalar> cut(Local_coordinates<Scalar>(site.point, frame, distance), cosine, sine);
  typename View::Halfedge edge = View::null_halfedge();
  Scalar y = 0, z = 0;
  const Walk_result<View> walk = walk_limb(view, site, cut, rule, [&](const Step<View>& step) {
    edge = step.exit != nullptr ? step.exit->edge : edge;
    y = step.y;
    z = step.z;
  });
  if(edge == View::null_halfedge())
    return {site, 0};
  const Vec3<Scalar> direction = cosine * frame.tangent + sine * frame.bitangent;
  return {site_at_point(view, edge, site.point + distance * (y * direction + z * frame.normal), distance),
          walk.reached};
}

/// returns the site at a distance straight ahead. Where the surface ends before twice that, it is half-way to its end:
/// so the site moves little by little with the distance and with the surface.
template <typename View>
Site<View> site_ahead(const View& view, const Site<View>& site, const Spider_frame<typename View::Scalar>& frame,
                      typename View::Scalar cosine, typename View::Scalar sine, typename View::Scalar distance)
{
  const auto reached = walk_ahead(view, site, frame, cosine, sine, 2 * distance).reached;
  return reached > 0 ? walk_ahead(view, site, frame, cosine, sine, reached * distance).site : site;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SITE_AHEAD_H
