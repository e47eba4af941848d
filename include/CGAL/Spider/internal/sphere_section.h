// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a sphere around the query point cuts the mesh, grown locally from that point (paper, 2.1).
//
// Inside one triangle the ball cuts out a convex region. Its boundary, counter-clockwise, alternates between parts of
// edges and arcs of the sphere: where the boundary leaves the ball through an edge, an arc leads to the next point where
// it comes back in. Where it comes back in, the neighbouring triangle's boundary leaves. Following that gives the
// section's polylines, closed or ending at borders.

#ifndef CGAL_SPIDER_INTERNAL_SPHERE_SECTION_H
#define CGAL_SPIDER_INTERNAL_SPHERE_SECTION_H

#include <CGAL/Spider/internal/Site.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

template <typename View>
class Sphere_section
{
  using Scalar = typename View::Scalar;
  using Halfedge = typename View::Halfedge;
  using Face = typename View::Face;
  using Point = Vec3<Scalar>;

public:
  using Polyline = std::vector<Point>; ///< relative to the query point, in units of the radius; closed if first == last

  Sphere_section(const View& view, const Site<View>& site, Scalar radius)
    : view_(view), origin_(site.point), radius_(radius)
  {
    for(Halfedge edge : site.rim)
      grow(edge);
    while(!to_visit_.empty())
    {
      const Halfedge h = to_visit_.back();
      to_visit_.pop_back();
      cut_triangle(h);
    }
  }

  /// returns the section's polylines; each runs counter-clockwise around the part of the mesh inside the sphere.
  std::vector<Polyline> polylines()
  {
    std::vector<Polyline> result = std::move(circles_);
    std::vector<Halfedge> at_border; // where open polylines start
    for(const auto& [leaving, arc] : arcs_)
      if(view_.opposite(leaving) == View::null_halfedge())
        at_border.push_back(leaving);
    for(Halfedge start : at_border)
      result.push_back(follow(start));
    while(!arcs_.empty())
      result.push_back(follow(arcs_.begin()->first));
    return result;
  }

private:
  /// Where an edge goes into the ball and where it comes out, as shares of its length.
  struct Edge_crossings
  {
    bool touches = false, enters = false, leaves = false;
    Scalar in = 0, out = 1;
  };

  struct Arc
  {
    Polyline points;   ///< from where the triangle's boundary leaves the ball up to where it enters again
    Halfedge entering; ///< the edge with the latter
  };

  Point local(typename View::Vertex v) const { return (view_.point(v) - origin_) / radius_; }

  Edge_crossings crossings(Halfedge h) const
  {
    // Both sides of an edge must see the same numbers, so they are computed along one direction of it.
    const bool forward = view_.source(h) < view_.target(h);
    const Point a = local(forward ? view_.source(h) : view_.target(h));
    const Point b = local(forward ? view_.target(h) : view_.source(h));
    const Point d = b - a;
    const Scalar dd = d.squaredNorm(), ad = a.dot(d);
    const bool a_inside = a.squaredNorm() < 1, b_inside = b.squaredNorm() < 1;
    const Scalar discriminant = dd - a.cross(d).squaredNorm(); // (ad)² - (dd) (aa - 1) would cancel out on long edges
    const Scalar root = std::sqrt(std::max(discriminant, Scalar(0)));
    Edge_crossings c;
    const Scalar in = (-ad - root) / dd, out = (-ad + root) / dd;
    const bool passes_through = !a_inside && !b_inside && discriminant > 0 && in > 0 && out < 1;
    c.touches = a_inside || b_inside || passes_through;
    c.enters = c.touches && !a_inside;
    c.leaves = c.touches && !b_inside;
    c.in = c.enters ? std::min(std::max(in, Scalar(0)), Scalar(1)) : Scalar(0);
    c.out = c.leaves ? std::min(std::max(out, Scalar(0)), Scalar(1)) : Scalar(1);
    if(!forward)
    {
      std::swap(c.enters, c.leaves);
      std::swap(c.in, c.out);
      c.in = 1 - c.in;
      c.out = 1 - c.out;
    }
    return c;
  }

  void grow(Halfedge h)
  {
    if(visited_.insert(view_.face(h)).second)
      to_visit_.push_back(h);
  }

  void cut_triangle(Halfedge h)
  {
    const auto [second, third] = view_.other_edges(h);
    const std::array<Halfedge, 3> edges = {h, second, third};
    std::array<Edge_crossings, 3> c;
    bool touched = false;
    for(int i = 0; i < 3; ++i)
    {
      c[i] = crossings(edges[i]);
      touched = touched || c[i].touches;
      const Halfedge neighbour = c[i].touches ? view_.opposite(edges[i]) : View::null_halfedge();
      if(neighbour != View::null_halfedge())
        grow(neighbour);
    }
    const Point a = local(view_.source(edges[0])), b = local(view_.source(edges[1])), d = local(view_.source(edges[2]));
    const Point normal = unit<Scalar>((b - a).cross(d - a)); // NaN in a face without area, whose arcs are chords
    const Point centre = a.dot(normal) * normal;
    if(!touched) // only a face around the query point gets here: the ball is smaller than the face
    {
      add_circle(centre, normal);
      return;
    }
    for(int i = 0; i < 3; ++i)
    {
      if(!c[i].leaves)
        continue;
      const Point from = at(edges[i], c[i].out);
      for(int k = 1; k <= 3; ++k) // the next edges around the face; the third is the edge itself
      {
        const int j = (i + k) % 3;
        if(!c[j].enters)
          continue;
        arcs_[edges[i]] = {arc(from, at(edges[j], c[j].in), centre, normal, i == j), edges[j]};
        break;
      }
    }
  }

  Point at(Halfedge h, Scalar share) const
  {
    const Point s = local(view_.source(h)), t = local(view_.target(h));
    return s + share * (t - s);
  }

  /// An arc's chord spans at most this angle, so it stays within half a percent of the radius of the sphere.
  static constexpr Scalar greatest_angle() { return Scalar(0.2); }

  Polyline arc(const Point& from, const Point& to, const Point& centre, const Point& normal, bool to_same_edge) const
  {
    if(!normal.allFinite())
      return {from, to};
    const Point u = from - centre, w = to - centre;
    const Scalar full_turn = 4 * std::acos(Scalar(0));
    Scalar angle = std::atan2(normal.dot(u.cross(w)), u.dot(w));
    // Where the sphere meets the vertex between two edges both ends are there, in whichever order rounding puts them. An
    // arc that goes all the way round from there would take a corner that is straight but for this angle.
    constexpr Scalar same_point = Scalar(1e-6);
    if(angle < 0 && (to_same_edge || angle < -same_point))
      angle += full_turn;
    return rotate(u, to, centre, normal, angle);
  }

  void add_circle(const Point& centre, const Point& normal)
  {
    const Scalar squared = 1 - centre.squaredNorm();
    if(!(squared > 0))
      return;
    const Point any = unit<Scalar>(local(view_.source(view_.halfedge(*visited_.begin()))) - centre);
    if(!any.allFinite())
      return;
    const Point start = std::sqrt(squared) * any;
    circles_.push_back(rotate(start, centre + start, centre, normal, 4 * std::acos(Scalar(0))));
  }

  Polyline rotate(const Point& u, const Point& end, const Point& centre, const Point& normal, Scalar angle) const
  {
    const int segments = std::max(1, static_cast<int>(std::ceil(angle / greatest_angle())));
    const Point v = normal.cross(u);
    Polyline points = {centre + u};
    for(int i = 1; i < segments; ++i)
      points.push_back(centre + std::cos(angle * i / segments) * u + std::sin(angle * i / segments) * v);
    points.push_back(end);
    return points;
  }

  /// takes the arcs that follow one another off the map and joins them.
  Polyline follow(Halfedge start)
  {
    Polyline polyline;
    Halfedge leaving = start;
    for(auto found = arcs_.find(start); found != arcs_.end(); found = arcs_.find(leaving))
    {
      const Arc arc = std::move(found->second);
      arcs_.erase(found);
      polyline.insert(polyline.end(), arc.points.begin() + (polyline.empty() ? 0 : 1), arc.points.end());
      leaving = view_.opposite(arc.entering);
      if(leaving == View::null_halfedge())
        return polyline;
    }
    if(leaving == start)
      polyline.back() = polyline.front(); // closed exactly
    return polyline;
  }

  const View& view_;
  Point origin_;
  Scalar radius_;
  std::set<Face> visited_;
  std::vector<Halfedge> to_visit_; ///< one edge of each face that the ball reaches
  std::map<Halfedge, Arc> arcs_;   ///< by the edge through which the boundary leaves the ball
  std::vector<Polyline> circles_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SPHERE_SECTION_H
