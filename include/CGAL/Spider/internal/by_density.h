// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What depends on how dense a mesh's vertices are: it is found for a few classes of vertices, each among edges of some
// length, and interpolated between them.

#ifndef CGAL_SPIDER_INTERNAL_BY_DENSITY_H
#define CGAL_SPIDER_INTERNAL_BY_DENSITY_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// Some of a range that is sorted by the length of edges.
template <typename Scalar>
struct Density_class
{
  std::size_t begin, end;
  Scalar edge_length; ///< the median
};

/// sorts into classes what has edges of the given lengths, in ascending order: one class for each time that lengths
/// grow by some octaves, with as many members each, and not fewer than `least_size`.
template <typename Scalar>
std::vector<Density_class<Scalar>> density_classes(const std::vector<Scalar>& edge_lengths, int octaves_per_class,
                                                   std::size_t least_size)
{
  constexpr std::size_t few = 20, most_classes = 8; // a twentieth at each end may be exceptional
  const std::size_t n = edge_lengths.size();
  std::vector<Density_class<Scalar>> classes;
  if(n == 0)
    return classes;
  const auto quantile = [&](std::size_t part, std::size_t of) { return edge_lengths[std::min(part * n / of, n - 1)]; };
  const Scalar octaves = std::log2(quantile(few - 1, few) / quantile(1, few));
  const Scalar wanted = std::min(std::ceil(octaves / octaves_per_class), Scalar(most_classes));
  const std::size_t count = std::max<std::size_t>(1, std::min(static_cast<std::size_t>(wanted), n / least_size));
  for(std::size_t i = 0; i < count; ++i)
    classes.push_back({i * n / count, (i + 1) * n / count, quantile(2 * i + 1, 2 * count)});
  return classes;
}

/// Numbers that go with lengths of edges.
template <typename Scalar>
class Table_by_density
{
public:
  bool empty() const { return entries_.empty(); }

  /// adds what goes with edges that are longer than those before.
  void add(Scalar edge_length, Scalar value) { entries_.push_back({edge_length, value}); }

  /// interpolates, logarithmically, and keeps what is at the ends beyond them.
  Scalar operator()(Scalar edge_length) const
  {
    const auto above = std::upper_bound(entries_.begin(), entries_.end(), edge_length,
                                        [](Scalar length, const Entry& entry) { return length < entry.edge_length; });
    if(above == entries_.begin())
      return above->value;
    const auto below = above - 1;
    if(above == entries_.end() || !(edge_length > 0) || !(below->value > 0))
      return below->value;
    const Scalar share = std::log(edge_length / below->edge_length) / std::log(above->edge_length / below->edge_length);
    return below->value * std::pow(above->value / below->value, share);
  }

private:
  struct Entry
  {
    Scalar edge_length, value;
  };

  std::vector<Entry> entries_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_BY_DENSITY_H
