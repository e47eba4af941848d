// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_LIMB_3_H
#define CGAL_SPIDER_LIMB_3_H

#include <CGAL/Spider/internal/cgal_compat.h>
#include <CGAL/Spider/internal/numbers.h>

#include <boost/graph/graph_traits.hpp>

#include <ostream>
#include <vector>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderClasses

Why a limb ends where it does (paper, 2.5).
*/
enum Limb_end
{
  radius_reached, ///< its length is the geodesic radius
  border,         ///< there is no next face
  feature_edge,   ///< it met a feature edge
  slowed,         ///< faces that cost more than 1 kept it short, or a wall that it climbs without getting farther
  degenerate      ///< the section can't be followed: it closes on itself, or starts in no face, or isn't finite
};

/// \ingroup PkgSpiderClasses
/// writes the name of an end.
inline std::ostream& operator<<(std::ostream& out, Limb_end end)
{
  switch(end)
  {
    case radius_reached: return out << "radius_reached";
    case border: return out << "border";
    case feature_edge: return out << "feature_edge";
    case slowed: return out << "slowed";
    default: return out << "degenerate";
  }
}

/*!
\ingroup PkgSpiderClasses

A limb: the polyline that a half plane, bounded by the normal at a point of a mesh, cuts out of the mesh, from that
point on (paper, 2.2).

\tparam TriangleMesh a model of `FaceGraph`
\tparam GT the kernel of the results: that of the mesh's points, or `Simple_cartesian<double>` where the number type of
           that kernel isn't floating-point
*/
template <typename TriangleMesh, typename GT = internal::Result_kernel_of_mesh<TriangleMesh>>
struct Limb_3
{
  using FT = typename GT::FT;           ///< the number type
  using Point_3 = typename GT::Point_3; ///< the type of the points
  /// an edge of the mesh
  using edge_descriptor = typename boost::graph_traits<TriangleMesh>::edge_descriptor;

  std::vector<Point_3> polyline; ///< from the query point to the limb's end; never empty
  FT length = FT(0);             ///< the length of `polyline`, at most the geodesic radius
  Limb_end end = degenerate;     ///< how the limb ended
  /// the edge where it ended early (`border`, `feature_edge`). Default-constructed for other ends, and where the limb
  /// leaves the mesh at the query point itself: it ends as `border` there, has no length, and crosses no edge.
  edge_descriptor edge{};
};

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_LIMB_3_H
