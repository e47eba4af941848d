// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Averages over the neighbourhoods of vertices, and vertices that are apart from each other.

#ifndef CGAL_SPIDER_INTERNAL_NEIGHBOURS_H
#define CGAL_SPIDER_INTERNAL_NEIGHBOURS_H

#include <CGAL/Spider/internal/Mesh_snapshot.h>
#include <CGAL/Spider/internal/for_each_chunk.h>
#include <CGAL/Spider/internal/numbers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// The neighbours of all vertices of a mesh. A vertex and its neighbours share what they have, as often as one likes:
/// after n rounds, that is the mean over about 5 n vertices, those nearby most.
class Neighbours
{
public:
  template <typename Scalar>
  explicit Neighbours(const Mesh_snapshot<Scalar>& mesh)
  {
    const std::uint32_t n = static_cast<std::uint32_t>(mesh.number_of_vertices());
    first_.reserve(n + 1);
    first_.push_back(0);
    for(std::uint32_t v = 0; v < n; ++v)
    {
      if(mesh.first_corner(v) != Mesh_snapshot<Scalar>::null_halfedge())
        mesh.visit_star(mesh.first_corner(v), [&](std::uint32_t a, std::uint32_t b) {
          neighbours_.push_back(a);
          neighbours_.push_back(b);
        });
      const auto begin = neighbours_.begin() + static_cast<std::ptrdiff_t>(first_.back());
      std::sort(begin, neighbours_.end());
      neighbours_.erase(std::unique(begin, neighbours_.end()), neighbours_.end());
      first_.push_back(neighbours_.size());
    }
  }

  /// calls `visit(w)` for the neighbours of a vertex.
  template <typename Visit>
  void visit(std::size_t v, const Visit& visit) const
  {
    for(std::size_t i = first_[v]; i < first_[v + 1]; ++i)
      visit(neighbours_[i]);
  }

  /// returns some of the given vertices, which come first as they are given: no two of them are within some edges of
  /// each other, and all others are within that of one of them. Three or more edges would take long.
  std::vector<std::uint32_t> apart(const std::vector<std::uint32_t>& vertices, int edges) const
  {
    std::vector<bool> is_near(first_.size() - 1);
    std::vector<std::uint32_t> chosen;
    for(std::uint32_t v : vertices)
      if(!is_near[v])
      {
        chosen.push_back(v);
        note_within(v, edges, is_near);
      }
    return chosen;
  }

  /// replaces the numbers of each vertex by the mean of its own and its neighbours', some times over.
  template <typename ConcurrencyTag, typename Scalar, std::size_t N>
  void average(std::vector<std::array<Scalar, N>>& values, int rounds) const
  {
    std::vector<std::array<Scalar, N>> next(values.size());
    for(int round = 0; round < rounds; ++round)
    {
      for_each_number<ConcurrencyTag>(values.size(), [&](std::size_t v) {
        std::array<Scalar, N> sum = values[v];
        visit(v, [&](std::uint32_t w) {
          for(std::size_t i = 0; i < N; ++i)
            sum[i] += values[w][i];
        });
        for(Scalar& number : sum)
          number /= static_cast<Scalar>(first_[v + 1] - first_[v] + 1);
        next[v] = sum;
      });
      std::swap(values, next);
    }
  }

private:
  void note_within(std::uint32_t v, int edges, std::vector<bool>& is_near) const
  {
    is_near[v] = true;
    if(edges > 0)
      visit(v, [&](std::uint32_t w) { note_within(w, edges - 1, is_near); });
  }

  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> neighbours_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_NEIGHBOURS_H
