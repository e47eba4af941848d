// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_RESAMPLE_H
#define CGAL_SPIDER_RESAMPLE_H

#include <CGAL/Spider/Limb_3.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Samples.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderTracing

resamples a limb at regular arc length (paper, 2.2): at `step`, twice `step` and so on from the query point, which is
the first point. The limb's end is the last one, so the last spacing may be shorter. Linear in the number of points read
and written.

\tparam TriangleMesh a model of `FaceGraph`
\tparam GT the kernel of the limb

\param limb the limb
\param step a positive length; the paper takes a tenth of the geodesic radius

\return the points, at least the first; a limb without length has no other
\throw std::invalid_argument if `step` isn't a positive, finite length, or would give more than ten million points
*/
template <typename TriangleMesh, typename GT>
std::vector<typename GT::Point_3> resample(const Limb_3<TriangleMesh, GT>& limb, typename GT::FT step)
{
  using FT = typename GT::FT;
  constexpr FT most_points = FT(1e7);
  internal::check_parameter(step > 0 && std::isfinite(step), "step", step, "give a positive, finite length");
  internal::check_parameter(limb.length <= most_points * step, "step", step,
                            "give a length of which fewer than ten million fit on the limb");

  std::vector<typename GT::Point_3> points = {limb.polyline.front()};
  FT length = 0;
  std::size_t count = 0;
  for(std::size_t i = 1; i < limb.polyline.size(); ++i)
  {
    const auto &from = limb.polyline[i - 1], &to = limb.polyline[i];
    const typename GT::Vector_3 segment = to - from;
    const bool is_last = i + 1 == limb.polyline.size();
    const FT end = is_last ? limb.length : length + std::hypot(segment.x(), segment.y(), segment.z());
    internal::sample_segment(length, end, step, count, [&](FT share) { points.push_back(from + share * segment); });
    length = end;
  }
  if(internal::end_is_apart(length, step, count))
    points.push_back(limb.polyline.back());
  return points;
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_RESAMPLE_H
