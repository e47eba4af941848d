// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_RING_CENTROID_H
#define CGAL_SPIDER_INTERNAL_RING_CENTROID_H

#include <CGAL/Spider/internal/Limb_bundle.h>
#include <CGAL/Spider/internal/Limb_directions.h>
#include <CGAL/Spider/internal/Mesh_snapshot.h>
#include <CGAL/Spider/internal/Star.h>
#include <CGAL/Spider/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns the mean length of the edges around a vertex; 0 where there are none.
template <typename Scalar>
Scalar mean_edge_length_at(const Mesh_snapshot<Scalar>& mesh, std::uint32_t v)
{
  Scalar sum = 0;
  const Site<Mesh_snapshot<Scalar>> site = site_at_vertex(mesh, v);
  for(std::uint32_t edge : site.rim)
    sum += (mesh.point(mesh.source(edge)) - site.point).stableNorm() +
           (mesh.point(mesh.target(edge)) - site.point).stableNorm();
  return site.rim.empty() ? Scalar(0) : sum / Scalar(2 * site.rim.size());
}

/// Finds where a vertex goes in a round of smoothing: towards the centroid of its geodesic ring (paper, 3.1). Keeps its
/// buffers, so every thread has its own.
template <typename Scalar>
class Ring_centroid
{
  using View = Mesh_snapshot<Scalar>;
  using Values = Lanes<Scalar>;
  using Vector = Vec3<Scalar>;

public:
  Ring_centroid(const View& mesh, int number_of_directions, Limb_measure measure, Ring_weight weight)
    : mesh_(mesh), measure_(measure), weight_(weight)
  {
    directions_.set(number_of_directions);
    ring_.resize(directions_.number_of_limbs);
  }

  /// returns the way from a site to its ring's centroid; zero where there is no ring. A ring that would reach beyond a
  /// line is made as narrow as that it doesn't, but not narrower than told: its centroid lies towards where limbs are
  /// whole.
  Vector operator()(const Site<View>& site, Scalar radius, Scalar narrowest, const Vector& normal)
  {
    if(site.rim.empty() || !(radius > 0) || !std::isfinite(radius) || !normal.allFinite())
      return Vector::Zero();
    const Spider_frame<Scalar> frame(normal, site.reference);
    trace_ring(site, frame, radius);
    if(distance_to_line_ < 1 && radius > narrowest)
    {
      radius = std::max(narrowest, distance_to_line_ * radius);
      trace_ring(site, frame, radius);
    }
    const Vector centroid = weight_ == by_arc ? centroid_by_arc() : centroid_by_limb();
    const Vector way =
      radius * (centroid.x() * frame.tangent + centroid.y() * frame.bitangent + centroid.z() * frame.normal);
    return way.allFinite() ? way : Vector(Vector::Zero());
  }

private:
  /// finds the limbs' ends in the frame, and how long the shortest of those is that a line ends, in units of the
  /// radius.
  void trace_ring(const Site<View>& site, const Spider_frame<Scalar>& frame, Scalar radius)
  {
    distance_to_line_ = 1;
    const Star<View> star(mesh_, site, Local_coordinates<Scalar>(site.point, frame, radius));
    for(std::size_t i = 0; i < directions_.cosines.size(); ++i)
    {
      const int count = directions_.limbs_in_bundle(i);
      const Values &cosines = directions_.cosines[i], &sines = directions_.sines[i];
      Limb_bundle<View> limbs(mesh_, site, star, cosines, sines, count, measure_);
      limbs.walk([](const auto&) {});
      const Values y = limbs.end_along_direction(), z = limbs.end_along_normal();
      for(int l = 0; l < count; ++l)
      {
        ring_[i * number_of_lanes + l] = {y[l] * cosines[l], y[l] * sines[l], z[l]};
        if(limbs.end(l) == border || limbs.end(l) == feature_edge)
          distance_to_line_ = std::min(distance_to_line_, limbs.reached(l));
      }
    }
  }

  Vector centroid_by_limb() const
  {
    Vector sum = Vector::Zero();
    for(const Vector& point : ring_)
      sum += point;
    return sum / Scalar(ring_.size());
  }

  Vector centroid_by_arc() const
  {
    Vector sum = Vector::Zero(), previous = ring_.back();
    Scalar length = 0;
    for(const Vector& point : ring_)
    {
      const Scalar arc = (point - previous).norm();
      sum += arc / 2 * (previous + point);
      length += arc;
      previous = point;
    }
    return sum / length;
  }

  const View& mesh_;
  Limb_measure measure_;
  Ring_weight weight_;
  Limb_directions<Scalar> directions_;
  std::vector<Vector> ring_;
  Scalar distance_to_line_ = 1;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_RING_CENTROID_H
