// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_GRAPH_VIEW_H
#define CGAL_SPIDER_INTERNAL_GRAPH_VIEW_H

#include <CGAL/Spider/internal/numbers.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Spider {
namespace internal {

[[noreturn]] inline void throw_not_triangulated()
{
  throw std::invalid_argument("Spider: tmesh has a face that is not a triangle: "
                              "call Polygon_mesh_processing::triangulate_faces() first");
}

/// The graph's own functions, for where members of the same name hide them. They are looked up by the graph's type, so
/// that its header may come after Spider's, and its namespace may be any.
namespace bgl {

template <typename Descriptor, typename Graph>
auto source_of(Descriptor h, const Graph& g) { return source(h, g); }

template <typename Descriptor, typename Graph>
auto target_of(Descriptor h, const Graph& g) { return target(h, g); }

template <typename Descriptor, typename Graph>
auto halfedge_of(Descriptor d, const Graph& g) { return halfedge(d, g); }

template <typename Descriptor, typename Graph>
auto face_of(Descriptor h, const Graph& g) { return face(h, g); }

template <typename Descriptor, typename Graph>
auto edge_of(Descriptor h, const Graph& g) { return edge(h, g); }

template <typename Descriptor, typename Graph>
auto opposite_of(Descriptor h, const Graph& g) { return opposite(h, g); }

} // namespace bgl

/// What the walk needs of a mesh, straight from the caller's `FaceGraph`: no set-up, for single queries.
template <typename TriangleMesh, typename VertexPointMap>
class Graph_view
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

public:
  using Scalar = Scalar_for<typename CGAL::Kernel_traits<Point>::Kernel::FT>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Face = typename Traits::face_descriptor;

  Graph_view(const TriangleMesh& tmesh, VertexPointMap vpm) : tmesh_(tmesh), vpm_(vpm) {}

  static Halfedge null_halfedge() { return Traits::null_halfedge(); }
  static Vertex null_vertex() { return Traits::null_vertex(); }
  static Face null_face() { return Traits::null_face(); }

  Vertex source(Halfedge h) const { return bgl::source_of(h, tmesh_); }
  Vertex target(Halfedge h) const { return bgl::target_of(h, tmesh_); }
  Halfedge halfedge(Face f) const { return bgl::halfedge_of(f, tmesh_); }
  Face face(Halfedge h) const { return bgl::face_of(h, tmesh_); }
  auto edge(Halfedge h) const { return bgl::edge_of(h, tmesh_); }
  Vec3<Scalar> point(Vertex v) const { return to_vec3<Scalar>(get(vpm_, v)); }

  /// returns the other half of an edge, or `null_halfedge()` where there is no face on that side.
  Halfedge opposite(Halfedge h) const
  {
    const Halfedge o = bgl::opposite_of(h, tmesh_);
    return CGAL::is_border(o, tmesh_) ? null_halfedge() : o;
  }

  /// Beyond an edge: where that is the face across, its apex and the halfedge that starts there; else NaN.
  struct Beyond
  {
    Vec3<Scalar> apex;
    Halfedge third;
  };

  Beyond beyond(Halfedge h) const
  {
    const Halfedge across = opposite(h);
    if(across == null_halfedge())
      return {nan_vec3<Scalar>(), h};
    const Halfedge third = other_edges(across).second;
    return {point(source(third)), third};
  }

  /// returns the halfedge that leads to the start of another one in its triangle.
  Halfedge preceding(Halfedge h) const { return prev(h, tmesh_); }

  /// returns the second and the third edge of the triangle at whose first edge `h` is.
  std::pair<Halfedge, Halfedge> other_edges(Halfedge h) const
  {
    const Halfedge second = next(h, tmesh_), third = next(second, tmesh_);
    if(third == h || next(third, tmesh_) != h)
      throw_not_triangulated();
    return {second, third};
  }

  /// returns the halfedge from `v` into the incident face whose edge opposite to `v` has the farthest midpoint, or
  /// `null_halfedge()` where there is no face. It stays the same corner when the mesh moves, scales, turns inside out
  /// or is held in another data structure, which makes it the place to measure directions from. Where several are as
  /// far, as on regular meshes, that whose two other vertices come first in the order of descriptors is taken.
  Halfedge first_corner(Vertex v) const
  {
    constexpr Scalar as_far = (1 - Scalar(1e-6)) * (1 - Scalar(1e-6)); // far above rounding; of squares
    Halfedge best = null_halfedge();
    const Scalar farthest = squared_distance_of_farthest_rim(v);
    std::pair<Vertex, Vertex> best_rim;
    for_each_corner(v, [&](Halfedge corner) {
      if(squared_distance_of_rim(corner) < as_far * farthest)
        return;
      const Halfedge opposite_edge = next(corner, tmesh_);
      const Vertex a = source(opposite_edge), b = target(opposite_edge);
      const std::pair<Vertex, Vertex> rim = b < a ? std::make_pair(b, a) : std::make_pair(a, b);
      if(best == null_halfedge() || rim < best_rim)
      {
        best = corner;
        best_rim = rim;
      }
    });
    return best;
  }

private:
  /// calls `visit(corner)` for the halfedge from `v` into each incident face.
  template <typename Visitor>
  void for_each_corner(Vertex v, Visitor&& visit) const
  {
    const Halfedge incoming = bgl::halfedge_of(v, tmesh_);
    if(incoming == null_halfedge())
      return;
    for(Halfedge h : CGAL::halfedges_around_target(incoming, tmesh_))
      if(!CGAL::is_border(h, tmesh_))
        visit(next(h, tmesh_));
  }

  /// returns four times the squared distance of a corner's vertex from the midpoint of the opposite edge.
  Scalar squared_distance_of_rim(Halfedge corner) const
  {
    const Vec3<Scalar> p = point(source(corner));
    const Halfedge opposite_edge = next(corner, tmesh_);
    return ((point(source(opposite_edge)) - p) + (point(target(opposite_edge)) - p)).squaredNorm();
  }

  Scalar squared_distance_of_farthest_rim(Vertex v) const
  {
    Scalar farthest = 0;
    for_each_corner(v, [&](Halfedge corner) { farthest = std::max(farthest, squared_distance_of_rim(corner)); });
    return farthest;
  }

  const TriangleMesh& tmesh_;
  VertexPointMap vpm_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_GRAPH_VIEW_H
