// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_ISOLINE_3_H
#define CGAL_SPIDER_ISOLINE_3_H

#include <CGAL/Spider/internal/cgal_compat.h>
#include <CGAL/Spider/internal/numbers.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderClasses

A polyline on a mesh along which a scalar, given at the vertices and linear in each face, has one value. Seen from the
side to which the faces point, the scalar is higher on its left.

No two successive points are the same, but a line may touch itself, or another one, at a vertex.

\tparam TriangleMesh a model of `FaceGraph`
\tparam GT the kernel of the results: that of the mesh's points, or `Simple_cartesian<double>` where the number type of
           that kernel isn't floating-point
*/
template <typename TriangleMesh, typename GT = internal::Result_kernel_of_mesh<TriangleMesh>>
struct Isoline_3
{
  using FT = typename GT::FT;           ///< the number type
  using Point_3 = typename GT::Point_3; ///< the type of the points
  /// What `CGAL::Polygon_mesh_processing::Face_location<TriangleMesh, FT>` is.
  using Face_location = std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<FT, 3>>;

  std::vector<Point_3> points; ///< at least two; a closed line repeats its first point at its end
  /// where each of `points` is on the mesh: the segment from point `i` to the next runs in the face
  /// `locations[i].first`, and the last location is in the face of the last segment.
  std::vector<Face_location> locations;
  bool is_closed = false; ///< lines that aren't closed end at borders, and where there is no finite scalar
};

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_ISOLINE_3_H
