// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TRACE_SPHERE_SECTION_H
#define CGAL_SPIDER_TRACE_SPHERE_SECTION_H

#include <CGAL/Spider/internal/build_limb.h>
#include <CGAL/Spider/internal/sphere_section.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderTracing

traces where the sphere of radius `geodesic_radius` around a query point cuts the mesh (paper, 2.1). The section is grown
locally: it bounds the part of the mesh inside the sphere that is connected, inside the sphere, with the query point.
Other parts that come near, of another component or another fold, don't count.

Inside a face the section is an arc of a circle; it is given by points on it, so close that no chord is farther than
half a percent of the radius from the sphere. It takes time in
O(n log n), n the number of faces that the sphere contains or meets.

\tparam Query a model of `SpiderQuery`
\tparam TriangleMesh a model of `FaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param query a vertex of `tmesh`, or a point of a face as a `CGAL::Polygon_mesh_processing::Face_location`
\param tmesh a triangle mesh; it is only read
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{geodesic_radius}
    \cgalParamDescription{the length that limbs grow to, in the mesh's units: the size of the smallest feature of interest}
    \cgalParamType{a number, or a readable property map from vertices to numbers}
    \cgalParamDefault{4 times the mean edge length}
    \cgalParamExtra{larger radii suppress more noise and blur more; the default takes a pass over all edges}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a readable property map from vertices to points}
    \cgalParamDefault{`get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{the kernel; results are in it where its numbers are floating-point}
    \cgalParamType{a \cgal kernel}
    \cgalParamDefault{deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return a vector of polylines, each a vector of points; a closed one repeats its first point at its end. None if the
sphere meets nothing. Seen from the side to which the faces point, each runs counter-clockwise around the surface inside.
\throw std::invalid_argument if a parameter is out of its range, or a face that is met isn't a triangle
*/
template <typename Query, typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto trace_sphere_section(const Query& query,
                          const TriangleMesh& tmesh,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  using Inputs = internal::Mesh_inputs<TriangleMesh, NamedParameters>;
  using Scalar = typename Inputs::Scalar;
  using Point_3 = typename Inputs::Result_traits::Point_3;
  const Inputs inputs(tmesh, np, section_fit, internal::whole_star);
  const internal::Query_point<Inputs> at(inputs, query);

  std::vector<std::vector<Point_3>> result;
  for(const auto& polyline :
      internal::Sphere_section<typename Inputs::View>(inputs.view, at.site, at.radius).polylines())
  {
    std::vector<Point_3> points;
    points.reserve(polyline.size());
    for(const internal::Vec3<Scalar>& p : polyline)
      points.push_back(internal::from_vec3<Point_3>(internal::Vec3<Scalar>(at.site.point + at.radius * p)));
    result.push_back(std::move(points));
  }
  return result;
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TRACE_SPHERE_SECTION_H
