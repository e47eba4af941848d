// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_CONTINUOUS_REFERENCE_H
#define CGAL_SPIDER_INTERNAL_CONTINUOUS_REFERENCE_H

#include <CGAL/Spider/internal/Site.h>
#include <CGAL/Spider/internal/Spider_frame.h>

#include <cmath>
#include <complex>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns where the spider of a site starts, so that it turns no more than a little on the way from one point of the
/// mesh to the next, and nowhere at once: few limbs see so few vertices that turning them changes what they tell. In a
/// face the site's own reference is an edge's direction, which changes from face to face. This is interpolated from the
/// references of the vertices. Where a limb starts doesn't matter, but only between which two: angles are interpolated
/// as points of a circle that the angle between two limbs goes around once.
template <typename View>
Vec3<typename View::Scalar> continuous_reference(const View& view,
                                                 const Site<View>& site,
                                                 const Vec3<typename View::Scalar>& normal,
                                                 int number_of_directions)
{
  using Scalar = typename View::Scalar;
  if(site.weights[0] == 1)
    return site.reference;
  const Spider_frame<Scalar> frame(normal, site.reference);
  const Scalar number_of_limbs = 2 * static_cast<Scalar>(number_of_directions);
  std::complex<Scalar> sum = 0;
  for(int i = 0; i < 3; ++i)
    if(site.weights[i] > 0)
    {
      const Vec3<Scalar> a = reference_at_corner(view, view.first_corner(site.vertices[i]));
      const Scalar angle = std::atan2(a.dot(frame.bitangent), a.dot(frame.tangent));
      if(std::isfinite(angle))
        sum += std::polar(site.weights[i], number_of_limbs * angle);
    }
  return frame.direction(std::arg(sum) / number_of_limbs);
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_CONTINUOUS_REFERENCE_H
