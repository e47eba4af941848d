// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the iteration of the normal starts (design: step 6 of the operator). All normals are unit, or NaN.

#ifndef CGAL_SPIDER_INTERNAL_FIRST_NORMAL_H
#define CGAL_SPIDER_INTERNAL_FIRST_NORMAL_H

#include <CGAL/Spider/internal/sphere_section.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/linear_least_squares_fitting_3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns the sum of the area vectors of the faces around a site, in units of the square of `unit_length`.
template <typename View>
Vec3<typename View::Scalar>
area_vector(const View& view, const Site<View>& site, typename View::Scalar unit_length)
{
  using Vector = Vec3<typename View::Scalar>;
  Vector sum = Vector::Zero();
  for(typename View::Halfedge edge : site.rim)
  {
    const Vector a = (view.point(view.source(edge)) - site.point) / unit_length;
    const Vector b = (view.point(view.target(edge)) - site.point) / unit_length;
    const Vector twice_area = a.cross(b);
    if(twice_area.allFinite())
      sum += twice_area / 2;
  }
  return sum;
}

/// `incident_faces`: cheap, and as noisy as the star is.
template <typename View>
Vec3<typename View::Scalar>
incident_faces_normal(const View& view, const Site<View>& site, typename View::Scalar radius)
{
  return unit(area_vector(view, site, radius));
}

/// `sphere_section`: normal to the best-fit plane of the polylines where the sphere cuts the mesh (paper, 2.1), on the
/// side of the incident faces'. NaN if the sphere doesn't cut the mesh.
template <typename View>
Vec3<typename View::Scalar>
sphere_section_normal(const View& view, const Site<View>& site, typename View::Scalar radius)
{
  using Scalar = typename View::Scalar;
  using Kernel = CGAL::Simple_cartesian<Scalar>;
  std::vector<typename Kernel::Segment_3> segments;
  for(const auto& polyline : Sphere_section<View>(view, site, radius).polylines())
    for(std::size_t i = 1; i < polyline.size(); ++i)
      if((polyline[i] - polyline[i - 1]).squaredNorm() > 0) // else it is a point, which has no share in the plane
        segments.emplace_back(from_vec3<typename Kernel::Point_3>(polyline[i - 1]),
                              from_vec3<typename Kernel::Point_3>(polyline[i]));
  if(segments.empty())
    return nan_vec3<Scalar>();
  typename Kernel::Plane_3 plane;
  CGAL::linear_least_squares_fitting_3(segments.begin(), segments.end(), plane, CGAL::Dimension_tag<1>());
  const Vec3<Scalar> normal = unit(to_vec3<Scalar>(plane.orthogonal_vector()));
  return normal.dot(area_vector(view, site, radius)) < 0 ? Vec3<Scalar>(-normal) : normal;
}

/// How often the area vectors are averaged over the neighbours for a given radius: about as many rings as fit into it,
/// so the neighbourhood grows with the radius, and at most eight, beyond which normals don't get better.
template <typename View>
int number_of_averaging_passes(const View& view, const Site<View>& vertex, typename View::Scalar radius)
{
  using Scalar = typename View::Scalar;
  constexpr int most_passes = 8;
  // Rounds up from .63 on: users choose radii of 2, 2.5 or 3 edges, where rounding must not decide.
  constexpr Scalar rounding_up = Scalar(0.37);
  Scalar sum = 0;
  for(typename View::Halfedge edge : vertex.rim)
    sum += ((view.point(view.source(edge)) - vertex.point) / radius).norm() +
           ((view.point(view.target(edge)) - vertex.point) / radius).norm();
  const Scalar rings = 2 * static_cast<Scalar>(vertex.rim.size()) / sum;
  return rings < most_passes ? std::max(1, static_cast<int>(rings + rounding_up)) : most_passes;
}

/// The vertices within some rings of one, with their stars, and the area vectors of these, averaged over neighbours.
template <typename View>
class Averaging_patch
{
  using Scalar = typename View::Scalar;
  using Vertex = typename View::Vertex;
  using Other_vertices = std::pair<std::size_t, std::size_t>; ///< of a face

public:
  Averaging_patch(const View& view, const Site<View>& centre, int rings, Scalar unit_length) : view_(view)
  {
    add(centre.vertices[0]);
    ring_ends_.push_back(1);
    for(int ring = 0; ring <= rings; ++ring) // the stars of the last ring reach one ring further
    {
      const std::size_t begin = stars_.size(), end = ring_ends_.back();
      for(std::size_t i = begin; i < end; ++i)
        add_star(vertices_[i], unit_length);
      ring_ends_.push_back(vertices_.size());
    }
  }

  /// In each pass, a vertex adds half of its neighbours' area vectors for every face that it shares with them.
  Vec3<Scalar> averaged()
  {
    for(std::size_t ring = ring_ends_.size() - 2; ring-- > 0;)
    {
      std::vector<Vec3<Scalar>> next(area_vectors_.begin(), area_vectors_.begin() + ring_ends_[ring]);
      for(std::size_t i = 0; i < next.size(); ++i)
        for(const auto& [a, b] : stars_[i])
          next[i] += area_vectors_[a] / 2 + area_vectors_[b] / 2;
      area_vectors_ = std::move(next);
    }
    return area_vectors_.front();
  }

private:
  std::size_t add(Vertex v)
  {
    const auto [entry, is_new] = index_.emplace(v, vertices_.size());
    if(is_new)
      vertices_.push_back(v);
    return entry->second;
  }

  void add_star(Vertex v, Scalar unit_length)
  {
    const Site<View> site = site_at_vertex(view_, v);
    std::vector<Other_vertices> star;
    for(typename View::Halfedge edge : site.rim)
    {
      const std::size_t source = add(view_.source(edge));
      star.emplace_back(source, add(view_.target(edge)));
    }
    stars_.push_back(std::move(star));
    area_vectors_.push_back(area_vector(view_, site, unit_length));
  }

  const View& view_;
  std::vector<Vertex> vertices_; ///< ring after ring
  std::map<Vertex, std::size_t> index_;
  std::vector<std::size_t> ring_ends_; ///< number of vertices within as many rings
  std::vector<std::vector<Other_vertices>> stars_;
  std::vector<Vec3<Scalar>> area_vectors_;
};

/// `neighbourhood` at a vertex: its area vector averaged over as many rings as fit into the radius.
template <typename View>
Vec3<typename View::Scalar>
neighbourhood_normal_at_vertex(const View& view, typename View::Vertex v, typename View::Scalar radius)
{
  const Site<View> site = site_at_vertex(view, v);
  if(site.rim.empty())
    return nan_vec3<typename View::Scalar>();
  const int passes = number_of_averaging_passes(view, site, radius);
  return unit(Averaging_patch<View>(view, site, passes, power_of_two_at_most(radius)).averaged());
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_FIRST_NORMAL_H
