// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_ESTIMATE_CURVATURES_H
#define CGAL_SPIDER_ESTIMATE_CURVATURES_H

#include <CGAL/Spider/Curvature_estimator.h>
#include <CGAL/Spider/internal/for_each_query.h>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderEstimation

estimates normals and principal curvatures at a range of points, as `estimate_curvature()` does at one.

It takes a pass over the mesh, whose memory is linear in the mesh's size, and then time linear in the number of faces that
limbs cross.

\tparam ConcurrencyTag `CGAL::Sequential_tag` (the default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`;
        the answers are the same to the last bit
\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\tparam QueryRange a range of vertices, or of `CGAL::Polygon_mesh_processing::Face_location`
\tparam OutputIterator an output iterator that takes `Curvature_estimate_3`, or a `std::vector` of them with `geodesic_radii`
\param queries the query points
\param tmesh a triangle mesh; it is only read
\param out takes one estimate per query, in their order
\param np an optional sequence of named parameters, those of `estimate_curvature()`, and
       `visitor`, a model of `SpiderVisitor` that is told how far the work is, and may cancel it by an exception

\return the output iterator behind the last estimate
\throw std::invalid_argument if a parameter is out of its range, a face isn't a triangle, or there are more than 268 million
faces
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename QueryRange,
          typename TriangleMesh,
          typename OutputIterator,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator estimate_curvatures(const QueryRange& queries,
                                   const TriangleMesh& tmesh,
                                   OutputIterator out,
                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  const Curvature_estimator<TriangleMesh, NamedParameters> estimator(tmesh, np, ConcurrencyTag());
  internal::for_each_query<ConcurrencyTag>(
    queries, [&] { return estimator.worker(); }, [&](const auto&, const auto& estimate) { *out++ = estimate; },
    internal::visitor_of(np));
  return out;
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_ESTIMATE_CURVATURES_H
