// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How curved a surface is on the whole, and what is flat by comparison.

#ifndef CGAL_SPIDER_INTERNAL_TYPICAL_CURVATURE_H
#define CGAL_SPIDER_INTERNAL_TYPICAL_CURVATURE_H

#include <CGAL/Spider/internal/numbers.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

template <typename Scalar>
struct Weighted_value
{
  Scalar value, weight;
};

/// returns the weighted mean of values without the largest ones, those that have `trimmed_share` of the weight; NaN
/// without any weight.
template <typename Scalar>
Scalar trimmed_mean(std::vector<Weighted_value<Scalar>> values, Scalar trimmed_share)
{
  std::sort(values.begin(), values.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  Scalar total = 0;
  for(const auto& [value, weight] : values)
    total += weight;
  Scalar left = (1 - trimmed_share) * total, kept = 0, mean = 0;
  for(const auto& [value, weight] : values)
  {
    const Scalar w = std::min(weight, left);
    if(!(w > 0))
      continue;
    left -= w;
    kept += w;
    mean += (value - mean) * (w / kept); // a running mean doesn't overflow
  }
  return kept > 0 ? mean : nan<Scalar>();
}

/// returns the length of the diagonal of the bounding box of the vertices with finite points.
template <typename View, typename TriangleMesh>
typename View::Scalar extent(const View& view, const TriangleMesh& tmesh)
{
  using Scalar = typename View::Scalar;
  Vec3<Scalar> low = Vec3<Scalar>::Constant(std::numeric_limits<Scalar>::infinity()), high = -low;
  for(const auto v : vertices(tmesh))
    if(const Vec3<Scalar> p = view.point(v); p.allFinite())
    {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  const Vec3<Scalar> diagonal = high - low;
  return std::hypot(diagonal.x(), diagonal.y(), diagonal.z());
}

/// returns a map from vertices to a third of their faces' areas, in units of the square of `unit_length`.
template <typename View, typename TriangleMesh>
auto vertex_areas(const View& view, const TriangleMesh& tmesh, typename View::Scalar unit_length)
{
  using Scalar = typename View::Scalar;
  auto areas = get(CGAL::dynamic_vertex_property_t<Scalar>(), tmesh);
  for(const auto v : vertices(tmesh))
    put(areas, v, Scalar(0));
  for(const auto f : faces(tmesh))
  {
    const auto h = view.halfedge(f);
    const auto a = view.source(h), b = view.target(h), c = view.target(view.other_edges(h).first);
    const Vec3<Scalar> ab = (view.point(b) - view.point(a)) / unit_length;
    const Vec3<Scalar> ac = (view.point(c) - view.point(a)) / unit_length;
    const Scalar area = ab.cross(ac).norm() / 2;
    if(std::isfinite(area))
      for(const auto v : {a, b, c})
        put(areas, v, get(areas, v) + area / 3);
  }
  return areas;
}

/// returns the curvature up to which `classify_vertices()` takes a surface for flat; NaN without any estimate.
template <typename View, typename TriangleMesh, typename CurvatureMap>
typename View::Scalar
default_flatness_threshold(const View& view, const TriangleMesh& tmesh, CurvatureMap curvature_map)
{
  using Scalar = typename View::Scalar;
  const Scalar size = extent(view, tmesh);
  const auto areas = vertex_areas(view, tmesh, size);
  std::vector<Weighted_value<Scalar>> curvatures;
  for(const auto v : vertices(tmesh))
  {
    const auto& estimate = get(curvature_map, v);
    const Scalar largest = std::max(std::abs(to_scalar<Scalar>(estimate.min_curvature)),
                                    std::abs(to_scalar<Scalar>(estimate.max_curvature)));
    if(std::isfinite(largest))
      curvatures.push_back({largest, get(areas, v)});
  }

  if(curvatures.empty())
    return nan<Scalar>();
  constexpr Scalar wild_share = Scalar(0.05); // where estimates may be of no use: on creases, at borders, by outliers
  // Well below 1, so that a shape with one curvature isn't flat anywhere; but the nearer to 1, the less of a surface is
  // so near to the threshold that another mesh of it makes another label. 0.75 and 0.5 differ by up to 2 % of the area.
  constexpr Scalar part_of_typical = Scalar(0.75);
  const Scalar threshold = part_of_typical * trimmed_mean(curvatures, wild_share);
  // An arc as long as the extent that has this curvature is 1 / 8000 of it high.
  constexpr Scalar least_bend = Scalar(1e-3);
  return threshold > least_bend / size ? threshold : least_bend / size; // NaN where estimates are on no area
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_TYPICAL_CURVATURE_H
