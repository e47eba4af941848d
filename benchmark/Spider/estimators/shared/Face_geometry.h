// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_SHARED_FACE_GEOMETRY_H
#define CGAL_SPIDER_BENCHMARK_SHARED_FACE_GEOMETRY_H

#include "../../Estimator.h"

#include <array>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace benchmark {

inline int next_corner(int i) { return i == 2 ? 0 : i + 1; }
inline int previous_corner(int i) { return i == 0 ? 2 : i - 1; }

// What one-ring estimators read off a triangle. Side i is opposite to corner i and runs along the face's orientation.
struct Face_geometry
{
  std::array<Mesh::Vertex_index, 3> vertices;
  std::array<Vector, 3> sides;
  std::array<double, 3> squared_lengths;
  std::array<double, 3> cosines; // of the corner's angle, times both adjacent lengths
  Vector doubled_area_vector;    // normal to the face, on the side that the face shows
  double doubled_area;

  Face_geometry(const Mesh& mesh, Mesh::Face_index face)
  {
    const Mesh::Halfedge_index h = mesh.halfedge(face);
    vertices = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
    for(int i = 0; i < 3; ++i)
    {
      sides[i] = mesh.point(vertices[previous_corner(i)]) - mesh.point(vertices[next_corner(i)]);
      squared_lengths[i] = sides[i].squared_length();
    }
    for(int i = 0; i < 3; ++i)
      cosines[i] = -(sides[next_corner(i)] * sides[previous_corner(i)]);
    doubled_area_vector = CGAL::cross_product(sides[0], sides[1]);
    doubled_area = std::sqrt(doubled_area_vector.squared_length());
  }

  double area() const { return doubled_area / 2; }
  double cotangent(int corner) const { return cosines[corner] / doubled_area; }
  double angle(int corner) const { return std::atan2(doubled_area, cosines[corner]); }

  // the corner whose angle is obtuse, or -1
  int obtuse_corner() const
  {
    for(int i = 0; i < 3; ++i)
      if(cosines[i] < 0)
        return i;
    return -1;
  }

  // The parts of the face that are nearer to one corner than to the other two, by corner: exact, obtuse or not.
  // In an obtuse face the bisector of a short side cuts a right triangle off at the acute corner.
  std::array<double, 3> nearest_areas() const
  {
    std::array<double, 3> areas;
    const int obtuse = obtuse_corner();
    if(obtuse < 0)
    {
      for(int i = 0; i < 3; ++i)
      {
        const int j = next_corner(i), k = previous_corner(i);
        areas[i] = (squared_lengths[j] * cotangent(j) + squared_lengths[k] * cotangent(k)) / 8;
      }
      return areas;
    }
    const int next = next_corner(obtuse), previous = previous_corner(obtuse);
    areas[next] = squared_lengths[previous] / (8 * cotangent(next));
    areas[previous] = squared_lengths[next] / (8 * cotangent(previous));
    areas[obtuse] = area() - areas[next] - areas[previous];
    return areas;
  }
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_SHARED_FACE_GEOMETRY_H
