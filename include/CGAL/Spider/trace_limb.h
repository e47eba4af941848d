// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TRACE_LIMB_H
#define CGAL_SPIDER_TRACE_LIMB_H

#include <CGAL/Spider/Limb_3.h>
#include <CGAL/Spider/internal/Mesh_inputs.h>
#include <CGAL/Spider/internal/build_limb.h>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderTracing

traces a limb: the polyline in which the half plane through the query point that is spanned by `direction` and `normal`
cuts the mesh, from the query point until its length is the geodesic radius (paper, 2.2). The last segment is shortened
so that the length is exactly that.

A limb ends early where there is no next face, at a feature edge, where the section closes on itself before the radius is
reached, and where the faces' cost slows it down.
It takes time linear in the number of faces that it crosses.

A vertex on the cutting plane counts as left of it, which settles all ties: a plane along an edge, through a vertex, or
across a face without area. Where a folded star is cut in several directions the limb takes the one that deviates least
from `direction`.

\tparam Query a model of `SpiderQuery`
\tparam TriangleMesh a model of `FaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param query a vertex of `tmesh`, or a point of a face as a `CGAL::Polygon_mesh_processing::Face_location`
\param normal the normal at the query point, of any kernel and any length but zero
\param direction the direction to go, of any kernel and any length; its part orthogonal to `normal` counts
\param tmesh a triangle mesh; it is only read
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{geodesic_radius}
    \cgalParamDescription{the length that limbs grow to, in the mesh's units: the size of the smallest feature of interest}
    \cgalParamType{a number, or a readable property map from vertices to numbers}
    \cgalParamDefault{4 times the mean edge length}
    \cgalParamExtra{larger radii suppress more noise and blur more; the default takes a pass over all edges}
  \cgalParamNEnd
  \cgalParamNBegin{limb_measure}
    \cgalParamDescription{what is measured along a limb until it reaches the radius}
    \cgalParamType{`Spider::Limb_measure`}
    \cgalParamDefault{`Spider::arc_length` (the paper's)}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges, at which limbs stop (paper, 2.5)}
    \cgalParamType{a readable property map from edges to `bool`}
    \cgalParamDefault{no feature edges}
    \cgalParamExtra{`CGAL::Polygon_mesh_processing::detect_sharp_edges()` fills one in}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_crossing_angle}
    \cgalParamDescription{a limb that meets a feature edge at a smaller angle between the edge and its plane goes on}
    \cgalParamType{a number of degrees from 0 to 90}
    \cgalParamDefault{30}
  \cgalParamNEnd
  \cgalParamNBegin{growth_cost_map}
    \cgalParamDescription{by how much length in a face counts: the dearer, the shorter limbs get; infinity stops them}
    \cgalParamType{a readable property map from faces to numbers of at least 1}
    \cgalParamDefault{1 for all faces}
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

\return a `Limb_3`; with an isolated vertex, one that consists of the vertex
\throw std::invalid_argument if a parameter is out of its range, or a face that is met isn't a triangle

\sa `trace_limbs()`
*/
template <typename Query,
          typename Normal,
          typename Direction,
          typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto trace_limb(const Query& query,
                const Normal& normal,
                const Direction& direction,
                const TriangleMesh& tmesh,
                const NamedParameters& np = CGAL::parameters::default_values())
{
  using Inputs = internal::Mesh_inputs<TriangleMesh, NamedParameters>;
  const Inputs inputs(tmesh, np, section_fit, internal::whole_star);
  const internal::Query_point<Inputs> at(inputs, query);
  const auto [n, d] = internal::checked_tangent_frame<typename Inputs::Scalar>(normal, direction);
  return internal::build_limb<TriangleMesh>(inputs, at, n, d);
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TRACE_LIMB_H
