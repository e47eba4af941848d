// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SITE_H
#define CGAL_SPIDER_INTERNAL_SITE_H

#include <CGAL/Spider/Limb_3.h>
#include <CGAL/Spider/internal/elongation.h>
#include <CGAL/Spider/internal/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// A query point and the faces around it, whether it is a vertex, on an edge or inside a face.
template <typename View>
struct Site
{
  using Scalar = typename View::Scalar;

  Vec3<Scalar> point = nan_vec3<Scalar>();
  Vec3<Scalar> reference = nan_vec3<Scalar>(); ///< a direction that moves with the mesh; spiders start at it
  std::vector<typename View::Halfedge> rim;    ///< edges, seen from within, that bound the union of the faces around it
  Limb_end end_at_once = degenerate;           ///< how a limb ends for which there is none of these faces
  /// what an attribute of the vertices is interpolated from, and by which weights
  std::array<typename View::Vertex, 3> vertices = {View::null_vertex(), View::null_vertex(), View::null_vertex()};
  std::array<Scalar, 3> weights{};
  Shortening<Scalar> shortening = Shortening<Scalar>::Zero(); ///< of limbs by their directions

  bool is_elongated() const { return !shortening.isZero(0); }
};

/// returns why a star ends with an edge.
template <typename View>
Limb_end end_of_star_at(const View& view, typename View::Halfedge h)
{
  return view.opposite(h) == View::null_halfedge() ? border : feature_edge;
}

/// calls `visit(corner)` for the halfedge from a vertex into each face of its star, given one of them; returns why the
/// star ends, `degenerate` if it goes all around.
template <typename View, typename Visitor>
Limb_end visit_corners(const View& view, typename View::Halfedge first, Visitor&& visit)
{
  using Halfedge = typename View::Halfedge;
  Halfedge corner = first, last = first;
  do // counter-clockwise ...
  {
    visit(corner);
    last = view.other_edges(corner).second;
    corner = view.opposite_in_star(last);
  } while(corner != first && corner != View::null_halfedge());
  if(corner == first)
    return degenerate;

  for(Halfedge incoming = view.opposite_in_star(first); incoming != View::null_halfedge();) // ... and then clockwise
  {
    corner = view.other_edges(incoming).first;
    visit(corner);
    incoming = view.opposite_in_star(corner);
  }
  return end_of_star_at(view, last);
}

/// returns the direction from a corner's vertex to the middle of the opposite edge, twice as long.
template <typename View>
Vec3<typename View::Scalar> reference_at_corner(const View& view, typename View::Halfedge corner)
{
  const Vec3<typename View::Scalar> p = view.point(view.source(corner));
  const typename View::Halfedge edge = view.other_edges(corner).first;
  return (view.point(view.source(edge)) - p) + (view.point(view.target(edge)) - p);
}

/// returns the site at a vertex, given a corner of the star, or `null_halfedge()` for an isolated vertex.
template <typename View>
Site<View> site_at_corner(const View& view, typename View::Vertex v, typename View::Halfedge first)
{
  Site<View> site;
  site.point = view.point(v);
  site.vertices = {v, v, v};
  site.weights = {1, 0, 0};
  if(first == View::null_halfedge())
    return site;
  const auto opposite_edge = [&](typename View::Halfedge corner) { return view.other_edges(corner).first; };
  constexpr int usual_most_faces = 8; // of a star: then the rim's buffer needn't grow
  site.rim.reserve(usual_most_faces);
  site.reference = reference_at_corner(view, first);
  site.end_at_once =
    visit_corners(view, first, [&](typename View::Halfedge corner) { site.rim.push_back(opposite_edge(corner)); });
  return site;
}

template <typename View>
Site<View> site_at_vertex(const View& view, typename View::Vertex v)
{
  return site_at_corner(view, v, view.first_corner(v));
}

template <typename View>
Site<View> site_on_edge(const View& view, typename View::Halfedge h, typename View::Scalar weight_of_source)
{
  Site<View> site;
  const auto s = view.source(h), t = view.target(h);
  const bool s_first = s < t; // the point is the same from both sides
  const auto a = s_first ? s : t, b = s_first ? t : s;
  const auto weight = s_first ? weight_of_source : 1 - weight_of_source;
  site.reference = view.point(b) - view.point(a);
  site.point = view.point(a) + (1 - weight) * site.reference;
  site.vertices = {a, b, b};
  site.weights = {weight, 1 - weight, 0};
  for(typename View::Halfedge side : {h, view.opposite_in_star(h)})
  {
    if(side == View::null_halfedge())
    {
      site.end_at_once = end_of_star_at(view, h);
      continue;
    }
    const auto [second, third] = view.other_edges(side);
    site.rim.push_back(second);
    site.rim.push_back(third);
  }
  return site;
}

/// returns the longest edge of a triangle as a vector that goes with its orientation, which doesn't depend on how the
/// mesh is stored; of several as long, that which comes first after the first of the vertices.
template <typename View>
Vec3<typename View::Scalar> longest_edge(const View& view, std::array<typename View::Vertex, 3> vertices)
{
  using Scalar = typename View::Scalar;
  constexpr Scalar longer = (1 + Scalar(1e-6)) * (1 + Scalar(1e-6)); // far above rounding; of squares
  std::rotate(vertices.begin(), std::min_element(vertices.begin(), vertices.end()), vertices.end());
  const auto edge = [&](int from, int to) {
    return Vec3<Scalar>(view.point(vertices[to]) - view.point(vertices[from]));
  };
  Vec3<Scalar> longest = edge(0, 1);
  for(const Vec3<Scalar>& other : {edge(1, 2), edge(2, 0)})
    if(other.squaredNorm() > longer * longest.squaredNorm())
      longest = other;
  return longest;
}

template <typename View>
Site<View> site_in_face(const View& view,
                        const std::array<typename View::Halfedge, 3>& edges,
                        const std::array<typename View::Scalar, 3>& weights)
{
  Site<View> site;
  site.rim.assign(edges.begin(), edges.end());
  site.vertices = {view.source(edges[0]), view.source(edges[1]), view.source(edges[2])};
  site.weights = weights;
  const Vec3<typename View::Scalar> a = view.point(site.vertices[0]);
  site.point = a + weights[1] * (view.point(site.vertices[1]) - a) + weights[2] * (view.point(site.vertices[2]) - a);
  site.reference = longest_edge(view, site.vertices);
  return site;
}

/// brings barycentric coordinates into order: those at rounding's level become zero, the rest sum to one.
template <typename Scalar>
std::array<Scalar, 3> checked_barycentric_coordinates(std::array<Scalar, 3> weights)
{
  // What locating a point in floating-point leaves behind stays well below this; a caller's slip does not.
  constexpr Scalar tolerated = Scalar(1e-6);
  constexpr Scalar rounding = 64 * std::numeric_limits<Scalar>::epsilon();
  const Scalar sum = weights[0] + weights[1] + weights[2];
  const Scalar least = std::min({weights[0], weights[1], weights[2]});
  if(!(std::abs(sum - 1) <= tolerated) || !(least >= -tolerated))
  {
    std::ostringstream message;
    message << "Spider: query has the barycentric coordinates (" << weights[0] << ", " << weights[1] << ", "
            << weights[2] << "): they must not be negative and must sum to 1, as those of "
            << "Polygon_mesh_processing::locate() do";
    throw std::invalid_argument(message.str());
  }
  for(Scalar& w : weights)
    w = w <= rounding ? Scalar(0) : w;
  const Scalar kept = weights[0] + weights[1] + weights[2];
  for(Scalar& w : weights)
    w /= kept;
  return weights;
}

/// returns the site at the vertex of a corner, with the star's part that the corner's face belongs to.
template <typename View>
Site<View> site_at_vertex_of_face(const View& view, typename View::Halfedge corner)
{
  const Site<View> site = site_at_vertex(view, view.source(corner));
  const typename View::Halfedge opposite_edge = view.other_edges(corner).first;
  const bool is_part = std::find(site.rim.begin(), site.rim.end(), opposite_edge) != site.rim.end();
  return is_part ? site : site_at_corner(view, view.source(corner), corner);
}

/// resolves a `PMP::Face_location`: coordinates belong to the source of the face's halfedge and to the next two vertices.
/// On a feature edge, the location's face tells which side is meant.
template <typename View>
Site<View> site_at_location(const View& view,
                            typename View::Face f,
                            const std::array<typename View::Scalar, 3>& coordinates)
{
  const auto weights = checked_barycentric_coordinates(coordinates);
  const typename View::Halfedge h = view.halfedge(f);
  const auto [second, third] = view.other_edges(h);
  const std::array<typename View::Halfedge, 3> edges = {h, second, third};
  for(int i = 0; i < 3; ++i)
    if(weights[i] == 1)
      return site_at_vertex_of_face(view, edges[i]);
  for(int i = 0; i < 3; ++i)
    if(weights[(i + 2) % 3] == 0) // edges[i] leads from vertex i to vertex i + 1
      return site_on_edge(view, edges[i], weights[i]);
  return site_in_face(view, edges, weights);
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SITE_H
