// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_MESH_SNAPSHOT_H
#define CGAL_SPIDER_INTERNAL_MESH_SNAPSHOT_H

#include <CGAL/Spider/internal/Graph_view.h>
#include <CGAL/Spider/internal/for_each_chunk.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// The ranks of a mesh's vertices or faces in the order of descriptors, whatever indices the mesh has or lacks. Where
/// descriptors are indices without gaps, they are their own ranks, and nothing is stored.
template <typename Descriptor>
class Ranks
{
public:
  template <typename Range>
  explicit Ranks(const Range& descriptors)
  {
    if constexpr(are_indices)
    {
      const auto is_own_rank = [this](Descriptor d) { return static_cast<std::size_t>(d) == size_++; };
      are_own_ranks_ = std::all_of(descriptors.begin(), descriptors.end(), is_own_rank);
    }
    if(are_own_ranks_)
      return;
    sorted_.assign(descriptors.begin(), descriptors.end());
    size_ = sorted_.size();
    if(!std::is_sorted(sorted_.begin(), sorted_.end()))
      std::sort(sorted_.begin(), sorted_.end());
  }

  std::size_t size() const { return size_; }

  Descriptor operator[](std::size_t rank) const
  {
    if constexpr(are_indices)
      if(are_own_ranks_)
        return Descriptor(rank);
    return sorted_[rank];
  }

  /// returns the rank, or `size()` for what isn't of the mesh.
  std::size_t operator()(Descriptor d) const
  {
    if constexpr(are_indices)
      if(are_own_ranks_)
        return std::min(static_cast<std::size_t>(d), size_);
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), d);
    return found != sorted_.end() && *found == d ? static_cast<std::size_t>(found - sorted_.begin()) : size_;
  }

private:
  static constexpr bool are_indices =
    std::is_convertible<Descriptor, std::size_t>::value && std::is_constructible<Descriptor, std::size_t>::value;

  std::size_t size_ = 0;
  bool are_own_ranks_ = false;
  std::vector<Descriptor> sorted_; ///< none if they are their own ranks
};

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

    const auto id = [&](Mesh_halfedge h) -> Halfedge {
      if(h == boost::graph_traits<TriangleMesh>::null_halfedge())
        return null_halfedge();
      const auto f = view.face(h);
      Halfedge result = static_cast<Halfedge>(4 * faces(f));
      for(Mesh_halfedge at = view.halfedge(f); at != h; at = next(at, tmesh))
        ++result;
      return result;
    };

    sources_.resize(3 * faces.size());
    thirds_across_.resize(3 * faces.size());
    growth_costs_.resize(view.has_growth_costs() ? faces.size() : 0);
    for_each_number<Reading_tag>(faces.size(), [&](std::size_t f) {
      const Mesh_halfedge first = view.halfedge(faces[f]);
      const auto [second, third] = view.other_edges(first);
      std::size_t slot = 3 * f;
      for(Mesh_halfedge h : {first, second, third})
      {
        sources_[slot] = static_cast<Vertex>(vertices(view.source(h)));
        const Mesh_halfedge across = view.opposite(h);
        thirds_across_[slot] =
          id(across == boost::graph_traits<TriangleMesh>::null_halfedge() ? across : view.other_edges(across).second);
        if(thirds_across_[slot] != null_halfedge())
          thirds_across_[slot] |=
            (view.is_feature(h) ? feature_flag : 0u) | (view.is_closed_to_growth(h) ? closed_flag : 0u);
        ++slot;
      }
      if(view.has_growth_costs())
        growth_costs_[f] = view.growth_cost(first);
    });
    stars_are_patches_ = view.star_extent() == patch_of_star;
    first_corners_.resize(vertices.size());
    for_each_number<Reading_tag>(
      vertices.size(), [&](std::size_t v) { first_corners_[v] = id(view.first_corner(vertices[v])); });
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
  std::size_t number_of_faces() const { return sources_.size() / 3; }
  Vertex source(Halfedge h) const { return sources_[slot(h)]; }
  Vertex target(Halfedge h) const { return sources_[slot(following(h))]; }
  Halfedge halfedge(Face f) const { return 4 * f; }
  Face face(Halfedge h) const { return h / 4; }
  const Vec3<Scalar>& point(Vertex v) const { return points_[v]; }
  const std::vector<Vec3<Scalar>>& points() const { return points_; }
  void move_to(std::vector<Vec3<Scalar>> points) { points_ = std::move(points); }
  Halfedge opposite(Halfedge h) const
  {
    const Halfedge third = thirds_across_[slot(h)];
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

  /// Beyond an edge: whether limbs of one patch may go on there, and then the halfedge that starts at the apex of the face
  /// across; else the edge itself.
  struct Beyond
  {
    Halfedge third;
    bool is_open;
  };

  Beyond beyond(Halfedge h) const
  {
    const Halfedge third = thirds_across_[slot(h)];
    const bool is_open = third < first_flagged;
    return {is_open ? third : h, is_open};
  }

  /// returns the halfedge that leads to the start of another one in its triangle.
  Halfedge preceding(Halfedge h) const { return (h & 3) == 0 ? h + 2 : h - 1; }

  std::pair<Halfedge, Halfedge> other_edges(Halfedge h) const
  {
    const Halfedge second = following(h);
    return {second, following(second)};
  }

  // The tables, for whoever looks up several places at once. Flags are set in that of halfedges, so that a single
  // comparison tells where a limb of one patch can go on.
  static constexpr Halfedge first_flagged = 1u << 30, closed_flag = first_flagged, feature_flag = 1u << 31;
  const Halfedge* thirds_across() const { return thirds_across_.data(); }
  const Vertex* sources() const { return sources_.data(); }
  const Scalar* coordinates() const { return points_.data()->data(); }

  /// returns the place of a halfedge, or of several in lanes, in the tables: 3f, 3f + 1 or 3f + 2.
  template <typename Halfedges>
  static Halfedges slot(const Halfedges& h)
  {
    return h - (h >> 2);
  }

private:

  bool has_flag(Halfedge h, Halfedge flag) const
  {
    const Halfedge third = thirds_across_[slot(h)];
    return third != null_halfedge() && (third & flag) != 0;
  }

  static Halfedge following(Halfedge h) { return (h & 3) == 2 ? h - 2 : h + 1; }

  std::vector<Vertex> sources_;
  std::vector<Halfedge> thirds_across_; ///< for each halfedge, the third edge of the face across, which starts at its apex
  std::vector<Halfedge> first_corners_;
  std::vector<Scalar> growth_costs_; ///< per face; none if all are 1
  bool stars_are_patches_ = false;
  std::vector<Vec3<Scalar>> points_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_MESH_SNAPSHOT_H
