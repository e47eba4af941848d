// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_MESH_LINES_H
#define CGAL_SPIDER_INTERNAL_MESH_LINES_H

#include <CGAL/Spider/internal/Mesh_snapshot.h>
#include <CGAL/Spider/internal/Site.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// The lines of a mesh, which smoothing keeps: its borders and feature edges.
template <typename Scalar>
class Mesh_lines
{
  using View = Mesh_snapshot<Scalar>;
  using Vertex = typename View::Vertex;

public:
  explicit Mesh_lines(const View& mesh) : mesh_(mesh), neighbours_(mesh.number_of_vertices())
  {
    const Vertex n = static_cast<Vertex>(mesh.number_of_vertices());
    for(Vertex v = 0; v < n; ++v)
      if(mesh.first_corner(v) != View::null_halfedge())
        find_neighbours(v);
  }

  bool is_on_line(Vertex v) const { return neighbours_[v].count > 0; }

  /// returns the way along its line, towards the farther of its two neighbours there, by which a vertex comes to lie in
  /// the middle between them. Vertices stay where lines end, meet or turn a corner.
  Vec3<Scalar> way_along_line(Vertex v) const
  {
    using Vector = Vec3<Scalar>;
    constexpr Scalar cosine_of_corner = Scalar(0.7); // lines that turn by more than 45 degrees do so on purpose
    const Neighbours& on_line = neighbours_[v];
    if(on_line.count != 2)
      return Vector::Zero();
    const Vector a = mesh_.point(on_line.vertices[0]) - mesh_.point(v);
    const Vector b = mesh_.point(on_line.vertices[1]) - mesh_.point(v);
    if(!(-unit(a).dot(unit(b)) >= cosine_of_corner))
      return Vector::Zero();
    const Scalar excess = b.norm() - a.norm();
    return excess > 0 ? Vector(excess / 2 * unit(b)) : Vector(-excess / 2 * unit(a));
  }

private:
  struct Neighbours
  {
    std::uint32_t count = 0;
    Vertex vertices[2] = {};

    void add(Vertex v)
    {
      if(count < 2)
        vertices[count] = v;
      ++count;
    }
  };

  void find_neighbours(Vertex v)
  {
    visit_corners(mesh_, mesh_.first_corner(v), [&](typename View::Halfedge leaving) {
      const auto arriving = mesh_.other_edges(leaving).second;
      if(mesh_.opposite(leaving) == View::null_halfedge() || mesh_.is_feature(leaving))
        neighbours_[v].add(mesh_.target(leaving));
      if(mesh_.opposite(arriving) == View::null_halfedge())
        neighbours_[v].add(mesh_.source(arriving));
    });
  }

  const View& mesh_;
  std::vector<Neighbours> neighbours_; ///< on lines
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_MESH_LINES_H
