// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a principal curvature is greatest along its own direction (Ohtake, Belyaev and Seidel 2004), as a graph: the
// crossings of those lines with the edges, and which crossing follows which.

#ifndef CGAL_SPIDER_INTERNAL_EXTREMALITY_H
#define CGAL_SPIDER_INTERNAL_EXTREMALITY_H

#include <CGAL/Spider/internal/Line_builder.h>
#include <CGAL/Spider/internal/numbers.h>

#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spider {
namespace internal {

/// The curvature across ridges, at a vertex.
template <typename Scalar>
struct Curvature_across
{
  Scalar curvature = 0, other = 0;               ///< positive on a ridge, and that along the ridge
  Vec3<Scalar> direction = Vec3<Scalar>::Zero(); ///< across, to either side
};

/// The curvature across a line that runs through a face, the mean over its corners, and how it falls off.
template <typename Scalar>
struct Ridge_in_face
{
  Scalar curvature = 0, sharpness = 0;
  bool is_ridge = false;
};

/*
The derivative of the curvature in its direction, the extremality, is linear on each face, and so are its zeros. Its
sign is that of the direction, which is arbitrary at each vertex: directions are turned to agree along each edge, and a
face whose three edges can't agree, as at an umbilic, has no line. Zero counts as positive in the vertex' own direction.
So an edge is crossed or not, whatever face asks, and each face by none or two of its edges: lines neither branch nor
break.

A crossing is named by the halfedge of the face that the line leaves there; each has two names, one for each way.
*/
template <typename View, typename TriangleMesh>
class Extremality
{
public:
  using Scalar = typename View::Scalar;
  using Vertex = typename View::Vertex;
  using Halfedge = typename View::Halfedge;
  using Location = std::pair<typename View::Face, std::array<Scalar, 3>>;

  /// `curvature_at` gives the `Curvature_across` of a vertex. Each pass averages gradients over neighbours.
  template <typename CurvatureAt>
  Extremality(const View& view, const TriangleMesh& tmesh, CurvatureAt&& curvature_at, int number_of_averaging_passes)
    : view_(view), values_(get(CGAL::dynamic_vertex_property_t<Value>(), tmesh))
  {
    for(const Vertex v : vertices(tmesh))
      put(values_, v, Value{curvature_at(v), Vec3<Scalar>::Zero(), 0, 0});
    for(const auto f : faces(tmesh))
      add_gradient(view.halfedge(f));
    for(int pass = 0; pass < number_of_averaging_passes; ++pass)
      average_gradients(tmesh);
    for(const Vertex v : vertices(tmesh))
    {
      Value value = get(values_, v);
      value.extremality = value.gradient.dot(value.across.direction) / value.area;
      put(values_, v, value);
    }
  }

  /// tells whether a line runs through the face of a halfedge and leaves it there. Whether there is a ridge is asked of
  /// the face alike at all of its halfedges, lest rounding let a line in that can't get out.
  bool is_crossing(Halfedge h) const
  {
    return h != View::null_halfedge() && is_crossed(h) && in_face(view_.halfedge(view_.face(h))).is_ridge;
  }

  /// returns the crossing that follows one on its line, or the null halfedge where the line ends.
  Halfedge next(Halfedge crossing) const
  {
    const Halfedge entry = view_.opposite(crossing);
    if(!is_crossing(entry))
      return View::null_halfedge();
    const auto [second, third] = view_.other_edges(entry);
    return is_crossed(second) ? second : third;
  }

  /// tells whether there is a ridge in the face of a halfedge, if a line of zero extremality runs through it: where the
  /// curvature is the greater one of the two, and greatest on the line.
  Ridge_in_face<Scalar> in_face(Halfedge first) const
  {
    const auto [second, third] = view_.other_edges(first);
    const Value a = get(values_, view_.source(first)), b = get(values_, view_.source(second)),
                c = get(values_, view_.source(third));
    const Scalar ab = agreement(a, b), ac = agreement(a, c);
    Ridge_in_face<Scalar> result;
    if(!(ab * ac * agreement(b, c) > 0)) // or NaN
      return result;
    result.curvature = (a.across.curvature + b.across.curvature + c.across.curvature) / 3;
    const Scalar other = (a.across.other + b.across.other + c.across.other) / 3;
    const Vec3<Scalar> direction = unit<Scalar>(a.across.direction + ab * b.across.direction + ac * c.across.direction);
    const auto [gradient, area] = gradient_times_area(first, {a.extremality, ab * b.extremality, ac * c.extremality});
    const Scalar second_derivative = gradient.dot(direction) / area;
    result.sharpness = -second_derivative / (result.curvature * result.curvature * result.curvature);
    result.is_ridge = result.curvature > std::abs(other) && result.sharpness > 0;
    return result;
  }

  Vec3<Scalar> point(Halfedge crossing) const
  {
    const Vec3<Scalar> source = view_.point(view_.source(crossing)), target = view_.point(view_.target(crossing));
    const Scalar share = share_of_target(crossing);
    return share == 1 ? target : Vec3<Scalar>(source + share * (target - source));
  }

  /// returns a crossing's place in the face that its line leaves there.
  Location location_behind(Halfedge crossing) const
  {
    return location_on_edge<Location>(view_, crossing, share_of_target(crossing));
  }

  /// returns a crossing's place in the face that its line enters there.
  Location location_ahead(Halfedge crossing) const
  {
    return location_on_edge<Location>(view_, view_.opposite(crossing), 1 - share_of_target(crossing));
  }

private:
  struct Value
  {
    Curvature_across<Scalar> across;
    Vec3<Scalar> gradient = Vec3<Scalar>::Zero(); ///< of the curvature, times the area of the faces around
    Scalar area = 0, extremality = 0;
  };

  /// returns 1 where the directions of two vertices agree, -1 where one of them is to be turned, else NaN.
  static Scalar agreement(const Value& a, const Value& b)
  {
    const Scalar cosine = a.across.direction.dot(b.across.direction);
    return cosine > 0 ? Scalar(1) : cosine < 0 ? Scalar(-1) : nan<Scalar>();
  }

  static Scalar sign(Scalar extremality)
  {
    return extremality >= 0 ? Scalar(1) : extremality < 0 ? Scalar(-1) : nan<Scalar>();
  }

  bool is_crossed(Halfedge h) const
  {
    const Value a = get(values_, view_.source(h)), b = get(values_, view_.target(h));
    return agreement(a, b) * sign(a.extremality) * sign(b.extremality) < 0;
  }

  Scalar share_of_target(Halfedge h) const
  {
    const Scalar at_source = std::abs(get(values_, view_.source(h)).extremality),
                 at_target = std::abs(get(values_, view_.target(h)).extremality);
    return at_source + at_target > 0 ? at_source / (at_source + at_target) : Scalar(0.5);
  }

  /// returns the gradient of a function that is linear on a face times the area, and the area. The values are at the
  /// starts of a halfedge and of the two that follow it.
  std::pair<Vec3<Scalar>, Scalar> gradient_times_area(Halfedge first, const std::array<Scalar, 3>& values) const
  {
    const Vec3<Scalar> p = view_.point(view_.source(first)), q = view_.point(view_.target(first)),
                       r = view_.point(view_.source(view_.other_edges(first).second));
    const Vec3<Scalar> area_vector = (q - p).cross(r - p) / 2;
    const Vec3<Scalar> turned = values[0] * (r - q) + values[1] * (p - r) + values[2] * (q - p);
    const Scalar area = area_vector.norm();
    return {area > 0 ? Vec3<Scalar>((area_vector / area).cross(turned) / 2) : Vec3<Scalar>(Vec3<Scalar>::Zero()), area};
  }

  /// adds a face's share to its corners' gradients.
  void add_gradient(Halfedge first)
  {
    const auto [second, third] = view_.other_edges(first);
    const std::array<Vertex, 3> corners = {view_.source(first), view_.source(second), view_.source(third)};
    const auto curvature = [&](int i) { return get(values_, corners[i]).across.curvature; };
    const auto [gradient, area] = gradient_times_area(first, {curvature(0), curvature(1), curvature(2)});
    if(!gradient.allFinite())
      return; // the corners that have an estimate make do with the other faces
    for(const Vertex v : corners)
    {
      Value value = get(values_, v);
      value.gradient += gradient;
      value.area += area;
      put(values_, v, value);
    }
  }

  /// replaces each vertex' gradient by the mean of it and its neighbours', by area.
  void average_gradients(const TriangleMesh& tmesh)
  {
    constexpr Scalar scale = Scalar(1) / 8; // sums of some seven neither grow nor vanish, and it rounds nothing
    auto sums = get(CGAL::dynamic_vertex_property_t<Value>(), tmesh);
    for(const Vertex v : vertices(tmesh))
      put(sums, v, get(values_, v));
    for(const auto h : halfedges(tmesh))
    {
      const Value from = get(values_, view_.source(h));
      Value to = get(sums, view_.target(h));
      to.gradient += from.gradient;
      to.area += from.area;
      put(sums, view_.target(h), to);
    }
    for(const Vertex v : vertices(tmesh))
    {
      Value sum = get(sums, v);
      sum.gradient *= scale;
      sum.area *= scale;
      put(values_, v, sum);
    }
  }

  View view_;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<Value>>::const_type values_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_EXTREMALITY_H
