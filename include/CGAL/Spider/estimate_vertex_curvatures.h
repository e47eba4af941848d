// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_ESTIMATE_VERTEX_CURVATURES_H
#define CGAL_SPIDER_ESTIMATE_VERTEX_CURVATURES_H

#include <CGAL/Spider/Curvature_estimator.h>
#include <CGAL/Spider/internal/for_each_query.h>

#include <boost/property_map/property_map.hpp>

#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

template <typename Result, typename GT>
Result answer_as(const Curvature_estimate_3<GT>& estimate)
{
  return Result(estimate);
}

template <typename Result, typename GT>
Result answer_as(const std::vector<Curvature_estimate_3<GT>>& estimates)
{
  return Result(estimates.begin(), estimates.end());
}

} // namespace internal

/*!
\ingroup PkgSpiderEstimation

estimates normals and principal curvatures at all vertices, as `estimate_curvature()` does at one.

It takes time linear in the size of the mesh and in the number of faces that limbs cross, which grows linearly with the
radius, and memory linear in the size of the mesh. A vertex without an estimate gets NaN and a status; it stops nothing.

\tparam ConcurrencyTag `CGAL::Sequential_tag` (the default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`;
        the answers are the same to the last bit
\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\tparam CurvatureMap a model of `WritablePropertyMap` from vertices to a model of `SpiderCurvatureResult`, such as
        `Curvature_estimate_3` of any kernel with floating-point numbers; with `geodesic_radii` to a container of them that
        is constructed from two iterators, such as a `std::vector`
\param tmesh a triangle mesh; it is only read
\param curvature_map takes the estimates
\param np an optional sequence of named parameters, those of `estimate_curvature()`, and
       `visitor`, a model of `SpiderVisitor` that is told how far the work is, and may cancel it by an exception

\throw std::invalid_argument if a parameter is out of its range, a face isn't a triangle, or there are more than 268 million
faces
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename TriangleMesh,
          typename CurvatureMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void estimate_vertex_curvatures(const TriangleMesh& tmesh,
                                CurvatureMap curvature_map,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  using Result = typename boost::property_traits<CurvatureMap>::value_type;
  const Curvature_estimator<TriangleMesh, NamedParameters> estimator(tmesh, np, ConcurrencyTag());
  internal::for_each_query<ConcurrencyTag>(
    estimator.template vertices_in_spatial_order<ConcurrencyTag>(), [&] { return estimator.worker(); },
    [&](const auto& v, const auto& estimate) { put(curvature_map, v, internal::answer_as<Result>(estimate)); },
    internal::visitor_of(np));
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_ESTIMATE_VERTEX_CURVATURES_H
