// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_GRAPH_VIEW_H
#define CGAL_SPIDER_INTERNAL_GRAPH_VIEW_H

#include <CGAL/Spider/internal/Growth_attributes.h>
#include <CGAL/Spider/internal/Site.h>
#include <CGAL/Spider/internal/numbers.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
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
template <typename TriangleMesh, typename VertexPointMap, typename Attributes = Growth_attributes<>>
class Graph_view
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

public:
  using Scalar = Scalar_for<typename CGAL::Kernel_traits<Point>::Kernel::FT>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Face = typename Traits::face_descriptor;

  /// Whether all that is read is the mesh's own and plain, so that several threads may read at once: what the caller's
  /// property maps or lazy numbers do when they are read isn't known.
  static constexpr bool reads_mesh_only =
    std::is_same<VertexPointMap,
                 typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>::value &&
    std::is_floating_point<typename CGAL::Kernel_traits<Point>::Kernel::FT>::value && !Attributes::has_features &&
    !Attributes::has_costs;

  Graph_view(const TriangleMesh& tmesh, VertexPointMap vpm, const Attributes& attributes = Attributes())
    : tmesh_(tmesh), vpm_(vpm), attributes_(attributes)
  {
  }

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

  Star_extent star_extent() const { return attributes_.star_extent(); }
  bool is_feature(Halfedge h) const { return attributes_.is_feature(edge(h)); }

  static constexpr bool has_growth_costs() { return Attributes::has_costs; }

  /// returns by how much a limb's length in the face of a halfedge counts: at least 1, infinite where limbs stop.
  Scalar growth_cost(Halfedge h) const { return attributes_.template cost<Scalar>(face(h)); }

  /// returns `opposite(h)`, but `null_halfedge()` where the star of the edge's vertices ends with the edge.
  Halfedge opposite_in_star(Halfedge h) const
  {
    return attributes_.star_extent() == patch_of_star && is_feature(h) ? null_halfedge() : opposite(h);
  }

  /// tells whether limbs stop at an edge since the face across has an infinite cost.
  bool is_closed_to_growth(Halfedge h) const
  {
    const Halfedge across = opposite(h);
    return Attributes::has_costs && across != null_halfedge() && !std::isfinite(growth_cost(across));
  }

  /// Beyond an edge: whether limbs of one patch may go on there, and then the apex of the face across and the halfedge
  /// that starts there; else the edge itself and where it starts.
  struct Beyond
  {
    Halfedge third;
    Vertex apex;
    bool is_open;
  };

  Beyond beyond(Halfedge h) const
  {
    const Halfedge across = opposite(h);
    if(across == null_halfedge() || is_feature(h) || is_closed_to_growth(h))
      return {h, source(h), false};
    const Halfedge third = other_edges(across).second;
    return {third, source(third), true};
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
  /// far, as on regular meshes, that whose two other vertices come first in the order of descriptors is taken. Where
  /// stars are patches, the corner is one of the patch that is widest at `v`.
  Halfedge first_corner(Vertex v) const
  {
    constexpr Scalar as_far = (1 - Scalar(1e-6)) * (1 - Scalar(1e-6)); // far above rounding; of squares
    Halfedge best = null_halfedge();
    Scalar farthest = 0;
    for_each_corner_of_star(v, [&](Halfedge corner) { farthest = std::max(farthest, squared_distance_of_rim(corner)); });
    std::pair<Vertex, Vertex> best_rim;
    for_each_corner_of_star(v, [&](Halfedge corner) {
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

  /// calls `visit(corner)` for the corners of all patches at `v` that are as wide as the widest.
  template <typename Visitor>
  void for_each_corner_of_star(Vertex v, Visitor&& visit) const
  {
    constexpr Scalar as_wide = 1 - Scalar(1e-6); // far above rounding
    bool has_patches = false;
    if(Attributes::has_features && attributes_.star_extent() == patch_of_star)
      for_each_corner(v, [&](Halfedge corner) { has_patches |= is_feature(corner); });
    if(!has_patches)
      return for_each_corner(v, visit);
    Scalar widest = 0;
    for_each_corner(v, [&](Halfedge corner) { widest = std::max(widest, angle_of_patch(corner)); });
    for_each_corner(v, [&](Halfedge corner) {
      if(!(angle_of_patch(corner) < as_wide * widest))
        visit(corner);
    });
  }

  /// returns the angle that a corner's patch fills around the corner's vertex.
  Scalar angle_of_patch(Halfedge first) const
  {
    Scalar sum = 0;
    visit_corners(*this, first, [&](Halfedge corner) {
      const Vec3<Scalar> p = point(source(corner));
      const Halfedge opposite_edge = next(corner, tmesh_);
      const Scalar angle =
        angle_between(unit<Scalar>(point(source(opposite_edge)) - p), unit<Scalar>(point(target(opposite_edge)) - p));
      if(std::isfinite(angle))
        sum += angle;
    });
    return sum;
  }

  const TriangleMesh& tmesh_;
  VertexPointMap vpm_;
  Attributes attributes_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_GRAPH_VIEW_H
