// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_ESTIMATE_NORMAL_H
#define CGAL_SPIDER_ESTIMATE_NORMAL_H

#include <CGAL/Spider/internal/build_limb.h>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns the normal from which a single query's spider starts.
template <typename Inputs>
Vec3<typename Inputs::Scalar> first_normal_of_query(const Inputs& inputs, const Query_point<Inputs>& query)
{
  return first_normal_of(inputs.view, query.site, query.radius, Inputs::has_given_normals, inputs.options.first_normal,
                         [&](typename Inputs::Vertex v) {
                           if constexpr(Inputs::has_given_normals)
                             return inputs.given_normal_at(v);
                           else
                             return neighbourhood_normal_at_vertex(inputs.view, v, inputs.radius_at(v));
                         });
}

} // namespace internal

/*!
\ingroup PkgSpiderEstimation

estimates the normal at a query point. Unlike that of `estimate_curvature()` it isn't iterated, and needs no limbs:

- `neighbourhood` averages the area vectors of faces over about as many rings as fit into the radius, at most eight;
- `sphere_section` takes the best-fit plane of `trace_sphere_section()` (paper, 2.1), or, if all of the component is
  inside the sphere, the above;
- `incident_faces` sums the area vectors of the faces around the query point.

With `geodesic_radius` given, it takes time linear in the number of faces looked at; with `sphere_section` that of
`trace_sphere_section()`.

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
  \cgalParamNBegin{first_normal}
    \cgalParamDescription{where normals come from that aren't given}
    \cgalParamType{`Spider::First_normal`}
    \cgalParamDefault{`Spider::neighbourhood`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_normal_map}
    \cgalParamDescription{normals to start from; they needn't be unit}
    \cgalParamType{a readable property map from vertices to vectors of any kernel}
    \cgalParamDefault{none: computed as `first_normal` says}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges: a point on one has the normal of one patch, of the widest around a vertex, or of
    the face of a `Face_location`}
    \cgalParamType{a readable property map from edges to `bool`}
    \cgalParamDefault{no feature edges}
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

\return a unit vector on the side to which the faces point; NaN where there is no face or none with an area
\throw std::invalid_argument if a parameter is out of its range, or a face that is met isn't a triangle

\sa `estimate_vertex_normals()`
*/
template <typename Query, typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto estimate_normal(const Query& query,
                     const TriangleMesh& tmesh,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  using Inputs = internal::Mesh_inputs<TriangleMesh, NamedParameters>;
  const Inputs inputs(tmesh, np, section_fit);
  return internal::from_vec3<typename Inputs::Result_traits::Vector_3>(
    internal::first_normal_of_query(inputs, internal::Query_point<Inputs>(inputs, query)));
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_ESTIMATE_NORMAL_H
