// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_LANE_EDGES_H
#define CGAL_SPIDER_INTERNAL_LANE_EDGES_H

#include <CGAL/Spider/internal/Lane_indices.h>
#include <CGAL/Spider/internal/Local_coordinates.h>
#include <CGAL/Spider/internal/Mesh_snapshot.h>

#include <array>
#include <cstdint>

namespace CGAL {
namespace Spider {
namespace internal {

/// What lies beyond the edges at which limbs in lockstep are: the apexes of the faces across, where limbs may go on.
template <typename View>
struct Lane_beyond
{
  using Mask = Lane_mask<typename View::Scalar>;
  static constexpr bool is_read_ahead = false; ///< whether to read before it is known which limb goes where

  std::array<typename View::Beyond, number_of_lanes> of_edges;

  Mask is_open() const
  {
    Mask open{};
    CGAL_SPIDER_FOR_EACH(l, 0, number_of_lanes)
      open.set(l, of_edges[l].is_open);
    return open;
  }

  Lane_points<typename View::Scalar> apexes(const View& view) const
  {
    std::array<typename View::Scalar, number_of_lanes> x, y, z;
    CGAL_SPIDER_FOR_EACH(l, 0, number_of_lanes)
    {
      const auto& point = view.point(of_edges[l].apex);
      x[l] = point.x();
      y[l] = point.y();
      z[l] = point.z();
    }
    return {Lanes<typename View::Scalar>(x), Lanes<typename View::Scalar>(y), Lanes<typename View::Scalar>(z)};
  }
};

/// The edges at which limbs in lockstep are, and what these ask a mesh there: lane by lane, in any view of it.
template <typename View>
class Lane_edges
{
  using Scalar = typename View::Scalar;
  using Halfedge = typename View::Halfedge;
  using Mask = Lane_mask<Scalar>;

public:
  Lane_edges() = default;
  explicit Lane_edges(Halfedge everywhere) { edges_.fill(everywhere); }

  Halfedge operator[](int lane) const { return edges_[lane]; }
  void set(int lane, Halfedge edge) { edges_[lane] = edge; }

  Lane_beyond<View> beyond(const View& view) const
  {
    Lane_beyond<View> beyond;
    CGAL_SPIDER_FOR_EACH(l, 0, number_of_lanes)
      beyond.of_edges[l] = view.beyond(edges_[l]);
    return beyond;
  }

  /// returns the edges that start at the apexes across, these edges themselves where limbs may not go on.
  Lane_edges thirds(const Lane_beyond<View>& beyond) const
  {
    Lane_edges edges;
    CGAL_SPIDER_FOR_EACH(l, 0, number_of_lanes)
      edges.edges_[l] = beyond.of_edges[l].third;
    return edges;
  }

  /// returns the edges that lead to where these start, in their triangles.
  Lane_edges preceding(const View& view) const
  {
    Lane_edges edges;
    CGAL_SPIDER_FOR_EACH(l, 0, number_of_lanes)
      edges.edges_[l] = view.preceding(edges_[l]);
    return edges;
  }

  friend Lane_edges select(const Mask& condition, const Lane_edges& a, const Lane_edges& b)
  {
    Lane_edges edges;
    CGAL_SPIDER_FOR_EACH(l, 0, number_of_lanes)
    {
      const Halfedge of_a = a.edges_[l], of_b = b.edges_[l]; // both are read, so that nothing branches
      edges.edges_[l] = condition[l] ? of_a : of_b;
    }
    return edges;
  }

  friend Mask operator==(const Lane_edges& a, const Lane_edges& b)
  {
    Mask same{};
    CGAL_SPIDER_FOR_EACH(l, 0, number_of_lanes)
      same.set(l, a.edges_[l] == b.edges_[l]);
    return same;
  }

private:
  std::array<Halfedge, number_of_lanes> edges_;
};

#if defined(CGAL_SPIDER_HAS_WIDE_PACKS)

// In a snapshot, edges are numbers and the rest is in tables: all lanes look at once. Machines with narrow registers
// are faster with one lane after the other.

template <typename Scalar>
struct Lane_beyond<Mesh_snapshot<Scalar>>
{
  using View = Mesh_snapshot<Scalar>;
  using Indices = Lane_indices<Scalar>;
  using Mask = Lane_mask<Scalar>;

  static constexpr bool is_read_ahead = true;

  Indices across; ///< as the snapshot packs it

  Indices thirds() const { return across & Indices(View::null_halfedge()); }
  Mask is_open() const { return thirds() < Indices(View::first_flagged); }

  Lane_points<Scalar> apexes(const View& view) const
  {
    const Indices vertex = across >> View::bits_of_third, at = vertex + vertex + vertex;
    Lane_points<Scalar> points;
    gather(view.coordinates(), at, points.x, points.y, points.z);
    return points;
  }

  friend Lane_beyond select(const Mask& condition, const Lane_beyond& a, const Lane_beyond& b)
  {
    return {select(condition, a.across, b.across)};
  }
};

template <typename Scalar>
class Lane_edges<Mesh_snapshot<Scalar>>
{
  using View = Mesh_snapshot<Scalar>;
  using Indices = Lane_indices<Scalar>;
  using Mask = Lane_mask<Scalar>;

public:
  Lane_edges() = default;
  explicit Lane_edges(std::uint32_t everywhere) : edges_(everywhere) {}

  std::uint32_t operator[](int lane) const { return edges_[lane]; }
  void set(int lane, std::uint32_t edge) { edges_.set(lane, edge); }

  Lane_beyond<View> beyond(const View& view) const { return {gather<Indices>(view.across(), View::slot(edges_))}; }

  Lane_edges thirds(const Lane_beyond<View>& beyond) const { return select(beyond.is_open(), beyond.thirds(), edges_); }

  Lane_edges preceding(const View&) const
  {
    const Mask is_first = (edges_ & Indices(3)) == Indices(0);
    return edges_ + select(is_first, Indices(2), Indices(0) - Indices(1));
  }

  friend Lane_edges select(const Mask& condition, const Lane_edges& a, const Lane_edges& b)
  {
    return select(condition, a.edges_, b.edges_);
  }

  friend Mask operator==(const Lane_edges& a, const Lane_edges& b) { return a.edges_ == b.edges_; }

private:
  Lane_edges(const Indices& edges) : edges_(edges) {}

  Indices edges_;
};

#endif

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LANE_EDGES_H
