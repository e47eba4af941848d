// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_FREE_VERTICES_H
#define CGAL_SPIDER_INTERNAL_FREE_VERTICES_H

#include <CGAL/Spider/internal/Mesh_lines.h>
#include <CGAL/Spider/internal/Mesh_snapshot.h>
#include <CGAL/Spider/internal/Star.h>
#include <CGAL/Spider/internal/for_each_chunk.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// The vertices that smoothing moves wherever it likes, which are neither fixed nor on lines nor isolated, and means of
/// what is known at them. Each pass takes time linear in the size of the mesh.
template <typename Scalar>
class Free_vertices
{
  using View = Mesh_snapshot<Scalar>;
  using Vertex = typename View::Vertex;

public:
  Free_vertices(const View& mesh, const Mesh_lines<Scalar>& lines, const std::vector<bool>& is_fixed)
    : mesh_(mesh), is_free_(mesh.number_of_vertices())
  {
    for(Vertex v = 0; v < static_cast<Vertex>(is_free_.size()); ++v)
      is_free_[v] = !is_fixed[v] && !lines.is_on_line(v) && mesh.first_corner(v) != View::null_halfedge();
  }

  bool contains(Vertex v) const { return is_free_[v]; }

  /// returns the means of the values at the free vertices around each free one; zero elsewhere, and where there are
  /// none.
  template <typename ConcurrencyTag>
  std::vector<Vec3<Scalar>> means_around(const std::vector<Vec3<Scalar>>& values) const
  {
    std::vector<Vec3<Scalar>> means(values.size(), Vec3<Scalar>::Zero());
    for_each_number<ConcurrencyTag>(values.size(), [&](std::size_t v) {
      int count = 0;
      visit_around(static_cast<Vertex>(v), [&](Vertex neighbour) {
        means[v] += values[neighbour];
        ++count;
      });
      if(count > 0)
        means[v] /= Scalar(count);
    });
    return means;
  }

  /// returns the mean squares of vectors at the free vertices of a neighbourhood of each free one; zero elsewhere. It
  /// reaches eight edges far, as a walk at random of as many steps does: half of its weight is within some two edges.
  template <typename ConcurrencyTag>
  std::vector<Scalar> mean_squares_near(const std::vector<Vec3<Scalar>>& vectors) const
  {
    constexpr int passes = 8; // enough vertices for a mean to be that of noise, and few enough to tell ears from bodies
    std::vector<Scalar> current(vectors.size()), next(vectors.size());
    for_each_number<ConcurrencyTag>(vectors.size(), [&](std::size_t v) {
      current[v] = contains(static_cast<Vertex>(v)) ? vectors[v].squaredNorm() : Scalar(0);
    });
    for(int pass = 0; pass < passes; ++pass)
    {
      for_each_number<ConcurrencyTag>(vectors.size(), [&](std::size_t v) {
        Scalar sum = current[v];
        int count = 1;
        visit_around(static_cast<Vertex>(v), [&](Vertex neighbour) {
          sum += current[neighbour];
          ++count;
        });
        next[v] = sum / Scalar(count);
      });
      std::swap(current, next);
    }
    return current;
  }

private:
  /// calls `visit(neighbour)` for the free vertices around a free one.
  template <typename Visit>
  void visit_around(Vertex v, const Visit& visit) const
  {
    if(!contains(v))
      return;
    visit_corners(mesh_, mesh_.first_corner(v), [&](typename View::Halfedge corner) {
      const Vertex neighbour = mesh_.target(corner); // a free vertex has as many corners as neighbours
      if(contains(neighbour))
        visit(neighbour);
    });
  }

  const View& mesh_;
  std::vector<bool> is_free_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_FREE_VERTICES_H
