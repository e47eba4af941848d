// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How far vertices go that are meant to move all at once: no farther than the faces around them stay sound.

#ifndef CGAL_SPIDER_INTERNAL_VERTEX_MOTION_H
#define CGAL_SPIDER_INTERNAL_VERTEX_MOTION_H

#include <CGAL/Spider/internal/Mesh_snapshot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// A face in one place.
template <typename Scalar>
struct Face_shape
{
  Vec3<Scalar> area_vector; ///< twice
  Scalar squared_length;    ///< of the longest edge

  Face_shape(const std::array<std::uint32_t, 3>& face, const std::vector<Vec3<Scalar>>& points)
  {
    const Vec3<Scalar> a = points[face[1]] - points[face[0]], b = points[face[2]] - points[face[0]];
    area_vector = a.cross(b);
    squared_length = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
  }

  /// returns the height over the longest edge, as a share of its length.
  Scalar relative_height() const { return area_vector.norm() / squared_length; }
};

/// tells whether a face that was sound stays so: that it neither turns over nor becomes a needle or worse.
template <typename Scalar>
bool stays_sound(const Face_shape<Scalar>& before, const Face_shape<Scalar>& after)
{
  constexpr Scalar least_height = Scalar(1e-3);
  if(!(before.area_vector.squaredNorm() > 0))
    return true; // nothing to lose
  return after.area_vector.dot(before.area_vector) > 0 &&
         after.relative_height() >= std::min(least_height, before.relative_height());
}

/// moves points by the given ways, or where a face wouldn't stay sound, its vertices by a half of them, a quarter, and
/// so on to nothing. Linear in the size of the mesh for each halving that takes place.
template <typename Scalar>
std::vector<Vec3<Scalar>> moved_as_far_as_sound(const Mesh_snapshot<Scalar>& mesh,
                                                const std::vector<Vec3<Scalar>>& ways)
{
  constexpr unsigned most_halvings = 4; // then the vertex stays
  const std::vector<Vec3<Scalar>>& before = mesh.points();
  std::vector<Vec3<Scalar>> after(before.size());
  std::vector<unsigned char> halvings(before.size(), 0);
  const auto move = [&](std::size_t v) {
    const Scalar share = halvings[v] > most_halvings ? 0 : std::ldexp(Scalar(1), -int(halvings[v]));
    after[v] = share > 0 ? Vec3<Scalar>(before[v] + share * ways[v]) : before[v];
    if(!after[v].allFinite()) // as where a step to the volume is divided by an area of nearly nothing
      after[v] = before[v];
  };
  for(std::size_t v = 0; v < before.size(); ++v)
    move(v);

  const std::uint32_t n = static_cast<std::uint32_t>(mesh.number_of_faces());
  bool is_sound = false;
  while(!is_sound)
  {
    is_sound = true;
    for(std::uint32_t f = 0; f < n; ++f)
    {
      const auto first = mesh.halfedge(f);
      const std::array<std::uint32_t, 3> face = {mesh.source(first), mesh.target(first),
                                                 mesh.source(mesh.preceding(first))};
      if(stays_sound(Face_shape<Scalar>(face, before), Face_shape<Scalar>(face, after)))
        continue;
      for(std::uint32_t v : face)
        if(halvings[v] <= most_halvings)
        {
          ++halvings[v];
          move(v);
          is_sound = false;
        }
    }
  }
  return after;
}

/// returns the volume that a closed mesh would enclose with its vertices at the given points.
template <typename Scalar>
Scalar enclosed_volume(const Mesh_snapshot<Scalar>& mesh, const std::vector<Vec3<Scalar>>& points)
{
  Scalar sum = 0;
  const std::uint32_t n = static_cast<std::uint32_t>(mesh.number_of_faces());
  for(std::uint32_t f = 0; f < n; ++f)
  {
    const auto first = mesh.halfedge(f);
    const Vec3<Scalar> apex = points[mesh.source(first)] - points[0]; // near the mesh, for the sake of rounding
    const Vec3<Scalar> a = points[mesh.target(first)] - points[0],
                       b = points[mesh.source(mesh.preceding(first))] - points[0];
    sum += apex.dot(a.cross(b));
  }
  return sum / 6;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_VERTEX_MOTION_H
