// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_MESH_SNAPSHOT_H
#define CGAL_SPIDER_INTERNAL_MESH_SNAPSHOT_H

#include <CGAL/Spider/internal/Graph_view.h>
#include <CGAL/Spider/internal/Ranks.h>
#include <CGAL/Spider/internal/for_each_chunk.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// What the walk needs of a mesh, copied once into arrays: for batches. Any number of threads may read it, and every
/// model of `FaceGraph` runs at the same speed. The halfedges of face f are 4f, 4f + 1 and 4f + 2.
template <typename Scalar_>
class Mesh_snapshot
{
public:
  using Scalar = Scalar_;
  using Vertex = std::uint32_t;
  using Halfedge = std::uint32_t;
  using Face = std::uint32_t;

  template <typename TriangleMesh, typename VertexPointMap, typename Attributes,
            typename ConcurrencyTag = CGAL::Sequential_tag>
  Mesh_snapshot(const TriangleMesh& tmesh,
                const Graph_view<TriangleMesh, VertexPointMap, Attributes>& view,
                const Ranks<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertices,
                const Ranks<typename boost::graph_traits<TriangleMesh>::face_descriptor>& faces,
                ConcurrencyTag = ConcurrencyTag())
  {
    using View = Graph_view<TriangleMesh, VertexPointMap, Attributes>;
    using Reading_tag = std::conditional_t<View::reads_mesh_only, ConcurrencyTag, CGAL::Sequential_tag>;
    using Mesh_halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
    if(4 * faces.size() >= first_flagged)
      throw std::invalid_argument("Spider: tmesh has more than 268 million faces: split it");

    const Mesh_halfedge mesh_null = boost::graph_traits<TriangleMesh>::null_halfedge();
    const auto id = [&](Mesh_halfedge h) -> Halfedge {
      const auto f = view.face(h);
      Halfedge result = static_cast<Halfedge>(4 * faces(f));
      for(Mesh_halfedge at = view.halfedge(f); at != h; at = next(at, tmesh))
        ++result;
      return result;
    };

    // what lies across a halfedge, given that which leads to it in its triangle
    const auto across = [&](Mesh_halfedge h, Mesh_halfedge preceding) {
      const Mesh_halfedge opposite = view.opposite(h);
      if(opposite == mesh_null)
        return packed(null_halfedge(), static_cast<Vertex>(vertices(view.source(preceding))));
      const Mesh_halfedge third = view.other_edges(opposite).second;
      const Halfedge flags =
        (view.is_feature(h) ? feature_flag : 0u) | (view.is_closed_to_growth(h) ? closed_flag : 0u);
      return packed(id(third) | flags, static_cast<Vertex>(vertices(view.source(third))));
    };

    across_.resize(3 * faces.size());
    growth_costs_.resize(view.has_growth_costs() ? faces.size() : 0);
    for_each_number<Reading_tag>(faces.size(), [&](std::size_t f) {
      const Mesh_halfedge first = view.halfedge(faces[f]);
      const auto [second, third] = view.other_edges(first);
      std::size_t slot = 3 * f;
      for(const auto& [h, preceding] : {std::pair(first, third), std::pair(second, first), std::pair(third, second)})
        across_[slot++] = across(h, preceding);
      if(view.has_growth_costs())
        growth_costs_[f] = view.growth_cost(first);
    });
    stars_are_patches_ = view.star_extent() == patch_of_star;
    first_corners_.resize(vertices.size());
    for_each_number<Reading_tag>(vertices.size(), [&](std::size_t v) {
      const Mesh_halfedge corner = view.first_corner(vertices[v]);
      first_corners_[v] = corner == mesh_null ? null_halfedge() : id(corner);
    });
    points_ = points_of(view, vertices);
  }

  /// returns a mesh's points as `move_to()` takes them.
  template <typename View, typename Vertices>
  static std::vector<Vec3<Scalar>> points_of(const View& view, const Vertices& vertices)
  {
    std::vector<Vec3<Scalar>> points;
    points.reserve(vertices.size());
    for(std::size_t v = 0; v < vertices.size(); ++v)
      points.push_back(view.point(vertices[v]));
    return points;
  }

  static constexpr Halfedge null_halfedge() { return std::numeric_limits<Halfedge>::max(); }
  static constexpr Vertex null_vertex() { return std::numeric_limits<Vertex>::max(); }
  static constexpr Face null_face() { return std::numeric_limits<Face>::max(); }

  std::size_t number_of_vertices() const { return first_corners_.size(); }
  std::size_t number_of_faces() const { return across_.size() / 3; }
  Vertex source(Halfedge h) const { return facing(following(h)); }
  Vertex target(Halfedge h) const { return facing(preceding(h)); }
  Halfedge halfedge(Face f) const { return 4 * f; }
  Face face(Halfedge h) const { return h / 4; }
  const Vec3<Scalar>& point(Vertex v) const { return points_[v]; }
  const std::vector<Vec3<Scalar>>& points() const { return points_; }
  void move_to(std::vector<Vec3<Scalar>> points) { points_ = std::move(points); }
  Halfedge opposite(Halfedge h) const
  {
    const Halfedge third = third_across(h);
    return third == null_halfedge() ? third : following(third & ~(feature_flag | closed_flag));
  }
  Halfedge opposite_in_star(Halfedge h) const
  {
    return stars_are_patches_ && is_feature(h) ? null_halfedge() : opposite(h);
  }
  bool is_feature(Halfedge h) const { return has_flag(h, feature_flag); }
  bool is_closed_to_growth(Halfedge h) const { return has_flag(h, closed_flag); }
  bool has_growth_costs() const { return !growth_costs_.empty(); }
  Scalar growth_cost(Halfedge h) const { return has_growth_costs() ? growth_costs_[face(h)] : Scalar(1); }
  Halfedge first_corner(Vertex v) const { return first_corners_[v]; }

  /// Beyond an edge: whether limbs of one patch may go on there, and then the apex of the face across and the halfedge that
  /// starts there; else the edge itself, and any vertex.
  struct Beyond
  {
    Halfedge third;
    Vertex apex;
    bool is_open;
  };

  Beyond beyond(Halfedge h) const
  {
    const Halfedge third = third_across(h);
    const bool is_open = third < first_flagged;
    return {is_open ? third : h, apex(across_[slot(h)]), is_open};
  }

  /// returns the halfedge that leads to the start of another one in its triangle.
  Halfedge preceding(Halfedge h) const { return (h & 3) == 0 ? h + 2 : h - 1; }

  std::pair<Halfedge, Halfedge> other_edges(Halfedge h) const
  {
    const Halfedge second = following(h);
    return {second, following(second)};
  }

  /// calls `visit(a, b)` for the two other vertices of each face that `visit_corners()` comes to: each is found on the way
  /// to the next face, which takes half as long as to ask for them.
  template <typename Visitor>
  void visit_star(Halfedge first, const Visitor& visit) const
  {
    const Vertex begin = target(first);
    Vertex a = begin, b = facing(first);
    for(Halfedge corner = first; corner != null_halfedge();) // counter-clockwise ...
    {
      visit(a, b);
      const Halfedge last = preceding(corner);
      corner = opposite_in_star(last);
      if(corner == first)
        return;
      a = b;
      b = apex(across_[slot(last)]);
    }
    b = begin;
    for(Halfedge incoming = opposite_in_star(first), corner = first; incoming != null_halfedge();) // ... and clockwise
    {
      a = apex(across_[slot(corner)]);
      visit(a, b);
      corner = following(incoming);
      incoming = opposite_in_star(corner);
      b = a;
    }
  }

  // The tables, for whoever looks up several places at once. Flags are set in that of halfedges, so that a single
  // comparison tells where a limb of one patch can go on.
  static constexpr Halfedge first_flagged = 1u << 30, closed_flag = first_flagged, feature_flag = 1u << 31;
  static constexpr int bits_of_third = 32;
  const std::uint64_t* across() const { return across_.data(); }
  const Scalar* coordinates() const { return points_.data()->data(); }

  /// returns the place of a halfedge, or of several in lanes, in the tables: 3f, 3f + 1 or 3f + 2.
  template <typename Halfedges>
  static Halfedges slot(const Halfedges& h)
  {
    return h - (h >> 2);
  }

private:
  static std::uint64_t packed(Halfedge third, Vertex apex)
  {
    return static_cast<std::uint64_t>(apex) << bits_of_third | third;
  }

  static Vertex apex(std::uint64_t across) { return static_cast<Vertex>(across >> bits_of_third); }
  Halfedge third_across(Halfedge h) const { return static_cast<Halfedge>(across_[slot(h)]); }

  /// returns the vertex that isn't on a halfedge, of those of its triangle: the face across knows it.
  Vertex facing(Halfedge h) const
  {
    const Halfedge across = opposite(h);
    return apex(across_[slot(across == null_halfedge() ? h : across)]);
  }

  bool has_flag(Halfedge h, Halfedge flag) const
  {
    const Halfedge third = third_across(h);
    return third != null_halfedge() && (third & flag) != 0;
  }

  static Halfedge following(Halfedge h) { return (h & 3) == 2 ? h - 2 : h + 1; }

  /// For each halfedge the third edge of the face across, and the apex, where that edge starts, in the upper half: one
  /// look tells a limb all that it needs to go on. At borders the apex is that of the halfedge's own face.
  std::vector<std::uint64_t> across_;
  std::vector<Halfedge> first_corners_;
  std::vector<Scalar> growth_costs_; ///< per face; none if all are 1
  bool stars_are_patches_ = false;
  std::vector<Vec3<Scalar>> points_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_MESH_SNAPSHOT_H
