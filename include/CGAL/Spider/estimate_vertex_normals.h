// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_ESTIMATE_VERTEX_NORMALS_H
#define CGAL_SPIDER_ESTIMATE_VERTEX_NORMALS_H

#include <CGAL/Spider/Curvature_estimator.h>
#include <CGAL/Spider/internal/for_each_query.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderEstimation

estimates normals at all vertices, as `estimate_normal()` does at one.

With `neighbourhood` and `incident_faces` it takes time and memory linear in the size of the mesh.

\tparam ConcurrencyTag `CGAL::Sequential_tag` (the default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`;
        the answers are the same to the last bit
\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\tparam VertexNormalMap a model of `WritablePropertyMap` from vertices to vectors of any kernel
\param tmesh a triangle mesh; it is only read
\param vertex_normal_map takes the normals
\param np an optional sequence of named parameters, those of `estimate_normal()`, and `visitor`, a
       model of `SpiderVisitor` that is told how far the work is, and may cancel it by an exception

\throw std::invalid_argument if a parameter is out of its range, a face isn't a triangle, or there are more than 268 million
faces
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename TriangleMesh,
          typename VertexNormalMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void estimate_vertex_normals(const TriangleMesh& tmesh,
                             VertexNormalMap vertex_normal_map,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  using Vector = typename boost::property_traits<VertexNormalMap>::value_type;
  const Curvature_estimator<TriangleMesh, NamedParameters> estimator(tmesh, np, ConcurrencyTag());
  internal::for_each_query<ConcurrencyTag>(
    vertices(tmesh), [&] { return [&](const auto& v) { return estimator.normal(v); }; },
    [&](const auto& v, const auto& normal) { put(vertex_normal_map, v, Vector(normal.x(), normal.y(), normal.z())); },
    internal::visitor_of(np));
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_ESTIMATE_VERTEX_NORMALS_H
