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

  /// returns the edges that start at the apexes across where limbs may go on there, the edges themselves elsewhere.
  Lane_edges beyond(const View& view, Mask& is_open) const
  {
    Lane_edges third;
    std::array<Scalar, number_of_lanes> open;
    for(int l = 0; l < number_of_lanes; ++l)
    {
      const auto beyond = view.beyond(edges_[l]);
      third.edges_[l] = beyond.third;
      open[l] = beyond.is_open;
    }
    is_open = Lanes<Scalar>(open) > Lanes<Scalar>(0);
    return third;
  }

  /// returns the edges that lead to where these start, in their triangles.
  Lane_edges preceding(const View& view) const
  {
    Lane_edges edges;
    for(int l = 0; l < number_of_lanes; ++l)
      edges.edges_[l] = view.preceding(edges_[l]);
    return edges;
  }

  /// returns the points where the edges start.
  Lane_points<Scalar> sources(const View& view) const
  {
    std::array<Scalar, number_of_lanes> x, y, z;
    for(int l = 0; l < number_of_lanes; ++l)
    {
      const auto& point = view.point(view.source(edges_[l]));
      x[l] = point.x();
      y[l] = point.y();
      z[l] = point.z();
    }
    return {Lanes<Scalar>(x), Lanes<Scalar>(y), Lanes<Scalar>(z)};
  }

  friend Lane_edges select(const Mask& condition, const Lane_edges& a, const Lane_edges& b)
  {
    Lane_edges edges;
    for(int l = 0; l < number_of_lanes; ++l)
      edges.edges_[l] = condition[l] ? a.edges_[l] : b.edges_[l];
    return edges;
  }

  friend Mask operator==(const Lane_edges& a, const Lane_edges& b)
  {
    std::array<Scalar, number_of_lanes> same;
    for(int l = 0; l < number_of_lanes; ++l)
      same[l] = a.edges_[l] == b.edges_[l];
    return Lanes<Scalar>(same) > Lanes<Scalar>(0);
  }

private:
  std::array<Halfedge, number_of_lanes> edges_;
};

#if defined(CGAL_SPIDER_HAS_WIDE_PACKS)

/// In a snapshot, edges are numbers and the rest is in tables: all lanes look at once. Machines with narrow registers
/// are faster with one lane after the other.
template <typename Scalar>
class Lane_edges<Mesh_snapshot<Scalar>>
{
  using View = Mesh_snapshot<Scalar>;
  using Values = Lanes<Scalar>;
  using Indices = Lane_indices<Scalar>;
  using Mask = Lane_mask<Scalar>;

public:
  Lane_edges() = default;
  explicit Lane_edges(std::uint32_t everywhere) : edges_(everywhere) {}

  std::uint32_t operator[](int lane) const { return edges_[lane]; }
  void set(int lane, std::uint32_t edge) { edges_.set(lane, edge); }

  Lane_edges beyond(const View& view, Mask& is_open) const
  {
    const Indices third = gather<Indices>(view.thirds_across(), View::slot(edges_));
    is_open = third < Indices(View::first_flagged);
    return select(is_open, third, edges_);
  }

  Lane_edges preceding(const View&) const
  {
    const Mask is_first = (edges_ & Indices(3)) == Indices(0);
    return edges_ + select(is_first, Indices(2), Indices(0) - Indices(1));
  }

  Lane_points<Scalar> sources(const View& view) const
  {
    const Indices vertex = gather<Indices>(view.sources(), View::slot(edges_)), at = vertex + vertex + vertex;
    const Scalar* coordinates = view.coordinates();
    return {gather<Values>(coordinates, at), gather<Values>(coordinates + 1, at), gather<Values>(coordinates + 2, at)};
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
