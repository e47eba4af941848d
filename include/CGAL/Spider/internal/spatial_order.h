// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SPATIAL_ORDER_H
#define CGAL_SPIDER_INTERNAL_SPATIAL_ORDER_H

#include <CGAL/Spider/internal/Mesh_snapshot.h>
#include <CGAL/Spider/internal/for_each_chunk.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// spreads the ten lowest bits of a number: two zeros follow each.
inline std::uint32_t spread_bits(std::uint32_t a)
{
  a = (a | (a << 16)) & 0x030000ff;
  a = (a | (a << 8)) & 0x0300f00f;
  a = (a | (a << 4)) & 0x030c30c3;
  return (a | (a << 2)) & 0x09249249;
}

/// returns all vertices of a mesh along a Morton curve, so that what spiders of successive vertices cross is still in the
/// cache.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename Scalar>
std::vector<std::uint32_t> spatial_order(const Mesh_snapshot<Scalar>& mesh)
{
  constexpr int cells = 1 << 10; // along an axis
  const std::size_t n = mesh.number_of_vertices();
  Vec3<Scalar> least = nan_vec3<Scalar>(), greatest = nan_vec3<Scalar>();
  for(std::size_t v = 0; v < n; ++v)
  {
    const Vec3<Scalar>& p = mesh.point(static_cast<std::uint32_t>(v));
    if(!p.allFinite())
      continue;
    least = least.allFinite() ? Vec3<Scalar>(least.cwiseMin(p)) : p;
    greatest = greatest.allFinite() ? Vec3<Scalar>(greatest.cwiseMax(p)) : p;
  }
  const Scalar size = (greatest / cells - least / cells).maxCoeff();
  const auto cell = [&](Scalar x, Scalar from) {
    const Scalar at = (x - from) / size;
    return at > 0 ? static_cast<std::uint32_t>(std::min(at, Scalar(cells - 1))) : 0; // also where it isn't a number
  };

  const auto place = [&](std::uint32_t v) { // on the curve
    const Vec3<Scalar>& p = mesh.point(v);
    return spread_bits(cell(p.x(), least.x())) | spread_bits(cell(p.y(), least.y())) << 1 |
           spread_bits(cell(p.z(), least.z())) << 2;
  };

  // By parts of the curve, each in its own: a part is small enough for its keys to take hardly any memory.
  constexpr int bits_of_place = 30, bits_of_part = 12;
  const auto part = [&](std::uint32_t v) { return place(v) >> (bits_of_place - bits_of_part); };
  std::vector<std::size_t> ends((1 << bits_of_part) + 1, 0);
  for(std::uint32_t v = 0; v < n; ++v)
    ++ends[part(v) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin()); // where parts begin, and as they fill up ...
  std::vector<std::uint32_t> order(n);
  for(std::uint32_t v = 0; v < n; ++v)
    order[ends[part(v)]++] = v; // ... where they end
  for_each_chunk<ConcurrencyTag>(1 << bits_of_part, 1, [&](std::size_t i, std::size_t) {
    const auto begin = order.begin() + (i == 0 ? 0 : ends[i - 1]), end = order.begin() + ends[i];
    std::vector<std::uint64_t> keys; // the place, and the vertex in the lower half
    for(auto v = begin; v != end; ++v)
      keys.push_back(static_cast<std::uint64_t>(place(*v)) << 32 | *v);
    std::sort(keys.begin(), keys.end());
    std::transform(keys.begin(), keys.end(), begin, [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
  });
  return order;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SPATIAL_ORDER_H
