// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_NEIGHBOURHOOD_NORMALS_H
#define CGAL_SPIDER_INTERNAL_NEIGHBOURHOOD_NORMALS_H

#include <CGAL/Spider/internal/Mesh_snapshot.h>
#include <CGAL/Spider/internal/first_normal.h>
#include <CGAL/Spider/internal/for_each_chunk.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// `neighbourhood` at all vertices at once, as `neighbourhood_normal_at_vertex()` has it at one: the vertices' area
/// vectors, averaged over neighbours as often as each vertex' radius asks for. In time linear in the size of the mesh.
template <typename Scalar>
class Normal_averaging
{
  using Mesh = Mesh_snapshot<Scalar>;
  using Vertex = typename Mesh::Vertex;

public:
  template <typename ConcurrencyTag, typename Radius>
  Normal_averaging(ConcurrencyTag, const Mesh& mesh, const Radius& radius_at)
    : vectors_(mesh.number_of_vertices()), passes_(mesh.number_of_vertices())
  {
    const Scalar length = unit_length(radius_at);
    for_each_number<ConcurrencyTag>(vectors_.size(), [&](std::size_t i) {
      const Vertex v = static_cast<Vertex>(i);
      const Site<Mesh> site = site_at_vertex(mesh, v);
      const bool is_isolated = site.rim.empty();
      vectors_[i] = is_isolated ? nan_vec3<Scalar>() : area_vector(mesh, site, length);
      passes_[i] = static_cast<std::uint8_t>(is_isolated ? 0 : number_of_averaging_passes(mesh, site, radius_at(v)));
    });
  }

  /// returns the unit normals, NaN where there is none. The mesh's points aren't looked at.
  template <typename ConcurrencyTag>
  std::vector<Vec3<Scalar>> normals(ConcurrencyTag, const Mesh& mesh) &&
  {
    // All three coordinates at once would take more memory than anything before or after, one at a time takes longer.
    average<ConcurrencyTag, 2>(mesh, 0);
    average<ConcurrencyTag, 1>(mesh, 2);
    for_each_number<ConcurrencyTag>(vectors_.size(), [&](std::size_t v) { vectors_[v] = unit(vectors_[v]); });
    return std::move(vectors_);
  }

private:
  /// returns one for all, which doesn't matter as long as its square is neither huge nor tiny: to divide by powers of two
  /// doesn't round.
  template <typename Radius>
  Scalar unit_length(const Radius& radius_at) const
  {
    for(std::size_t v = 0; v < vectors_.size(); ++v)
    {
      const Scalar radius = radius_at(static_cast<Vertex>(v));
      if(radius > 0 && std::isfinite(radius))
        return power_of_two_at_most(radius);
    }
    return 1;
  }

  /// averages some coordinates.
  template <typename ConcurrencyTag, int count>
  void average(const Mesh& mesh, int first)
  {
    using Coordinates = Eigen::Matrix<Scalar, count, 1>;
    const std::size_t n = vectors_.size();
    std::vector<Coordinates> current(n), next(n);
    for_each_number<ConcurrencyTag>(n, [&](std::size_t v) { current[v] = vectors_[v].template segment<count>(first); });
    const int most_passes = n > 0 ? *std::max_element(passes_.begin(), passes_.end()) : 0;
    for(int pass = 1; pass <= most_passes; ++pass)
    {
      for_each_number<ConcurrencyTag>(n, [&](std::size_t v) {
        if(passes_[v] == 0)
          return;
        Coordinates sum = current[v];
        mesh.visit_star(mesh.first_corner(static_cast<Vertex>(v)),
                        [&](Vertex a, Vertex b) { sum += current[a] / 2 + current[b] / 2; });
        next[v] = sum;
        if(passes_[v] == pass)
          vectors_[v].template segment<count>(first) = sum;
      });
      std::swap(current, next);
    }
  }

  std::vector<Vec3<Scalar>> vectors_; ///< the area vectors, and then what they average to
  std::vector<std::uint8_t> passes_;  ///< none at isolated vertices
};

template <typename ConcurrencyTag = CGAL::Sequential_tag, typename Scalar, typename Radius>
std::vector<Vec3<Scalar>> neighbourhood_normals(const Mesh_snapshot<Scalar>& mesh, const Radius& radius_at)
{
  return Normal_averaging<Scalar>(ConcurrencyTag(), mesh, radius_at).normals(ConcurrencyTag(), mesh);
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_NEIGHBOURHOOD_NORMALS_H
