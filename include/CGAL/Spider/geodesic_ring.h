// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_GEODESIC_RING_H
#define CGAL_SPIDER_GEODESIC_RING_H

#include <CGAL/Spider/trace_limbs.h>

#include <boost/iterator/function_output_iterator.hpp>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderTracing

writes the end points of a spider's limbs (paper, 3.1), in angular order, counter-clockwise as seen from the tip of
`normal`. Limbs that end early contribute the point where they end, so the ring follows borders. It takes time linear in the
number of faces that limbs cross.

\tparam Query a model of `SpiderQuery`
\tparam TriangleMesh a model of `FaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\tparam OutputIterator an output iterator that takes points of the results' kernel
\param query a vertex of `tmesh`, or a point of a face as a `CGAL::Polygon_mesh_processing::Face_location`
\param normal the normal at the query point, of any kernel and any length but zero
\param out takes twice as many points as there are directions
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
  \cgalParamNBegin{number_of_directions}
    \cgalParamDescription{number of directions, spaced regularly over a half turn, with two limbs each}
    \cgalParamType{an even integer from 2 to 65536}
    \cgalParamDefault{64 (paper, 2.6)}
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

\return the output iterator behind the last point
\throw std::invalid_argument if a parameter is out of its range, or a face that is met isn't a triangle

\sa `trace_limbs()`
*/
template <typename Query,
          typename Normal,
          typename TriangleMesh,
          typename OutputIterator,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator geodesic_ring(const Query& query,
                             const Normal& normal,
                             const TriangleMesh& tmesh,
                             OutputIterator out,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto write_end = [&out](const auto& limb) { *out++ = limb.polyline.back(); };
  trace_limbs(query, normal, tmesh, boost::make_function_output_iterator(write_end), np);
  return out;
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_GEODESIC_RING_H
