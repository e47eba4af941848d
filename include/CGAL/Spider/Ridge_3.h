// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_RIDGE_3_H
#define CGAL_SPIDER_RIDGE_3_H

#include <CGAL/Spider/Isoline_3.h>

namespace CGAL {
namespace Spider {

/// \ingroup PkgSpiderUses
/// Which of the two kinds of lines a `Ridge_3` is, as seen from the side to which the faces point.
enum Ridge_kind
{
  ridge, ///< the surface bends away from the normal across it, more than beside it
  valley ///< the surface bends towards the normal across it, more than beside it
};

/*!
\ingroup PkgSpiderClasses

A ridge or a valley of a surface: a polyline on a mesh along which a principal curvature is greatest in its own
direction.

\tparam TriangleMesh a model of `FaceGraph`
\tparam GT the kernel of the results: that of the mesh's points, or `Simple_cartesian<double>` where the number type of
           that kernel isn't floating-point
*/
template <typename TriangleMesh, typename GT = internal::Result_kernel_of_mesh<TriangleMesh>>
struct Ridge_3
{
  using FT = typename GT::FT;           ///< the number type
  using Point_3 = typename GT::Point_3; ///< the type of the points
  /// What `CGAL::Polygon_mesh_processing::Face_location<TriangleMesh, FT>` is.
  using Face_location = typename Isoline_3<TriangleMesh, GT>::Face_location;

  std::vector<Point_3> points; ///< at least two; a closed line repeats its first point at its end
  /// where each of `points` is on the mesh: the segment from point `i` to the next runs in the face
  /// `locations[i].first`, and the last location is in the face of the last segment.
  std::vector<Face_location> locations;
  bool is_closed = false;  ///< whether the line comes back to its start
  Ridge_kind kind = ridge; ///< which it is
  /// the integral of the absolute curvature across the line over its length: the length in units of the radius of
  /// curvature, a number without a unit
  FT strength = 0;
  /// how fast curvature falls off to both sides: about 1 - `sharpness` x<sup>2</sup> / 2 of it is left at a distance of
  /// x radii of curvature; the mean over the line, a number without a unit
  FT sharpness = 0;
};

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_RIDGE_3_H
