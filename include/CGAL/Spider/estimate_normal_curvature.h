// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_ESTIMATE_NORMAL_CURVATURE_H
#define CGAL_SPIDER_ESTIMATE_NORMAL_CURVATURE_H

#include <CGAL/Spider/Curvature_estimate_3.h>
#include <CGAL/Spider/internal/section_fit.h>
#include <CGAL/Spider/internal/build_limb.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderClasses

The normal curvature of a surface at one point along one direction. What can't be estimated is NaN.

\tparam FT a floating-point number type
*/
template <typename FT>
struct Normal_curvature
{
  FT curvature = internal::nan<FT>();     ///< unit 1/length, positive where the surface bends away from the normal
  FT tangent_slope = internal::nan<FT>(); ///< of the section's tangent: its rise along the normal per length along the direction
  FT residual = internal::nan<FT>();      ///< root mean square distance of the samples to the fitted polynomial, a length
  Estimate_status status = isolated;      ///< how the estimate came about
};

/*!
\ingroup PkgSpiderEstimation

estimates the curvature along a direction (paper, 2.2): the two limbs along `direction` and against it are resampled, and
a polynomial through the query point, its tangent pulled towards the direction, is fitted to the samples by least squares.
It takes time linear in the number of faces that the two limbs cross.

\tparam Query a model of `SpiderQuery`
\tparam TriangleMesh a model of `FaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param query a vertex of `tmesh`, or a point of a face as a `CGAL::Polygon_mesh_processing::Face_location`
\param normal the normal at the query point, of any kernel and any length but zero
\param direction the direction, of any kernel and any length; its part orthogonal to `normal` counts
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
  \cgalParamNBegin{polynomial_degree}
    \cgalParamDescription{degree of the fitted polynomials}
    \cgalParamType{2, 3 or 4}
    \cgalParamDefault{2}
  \cgalParamNEnd
  \cgalParamNBegin{resampling_step}
    \cgalParamDescription{distance of samples along a limb, as a share of the radius}
    \cgalParamType{a number from 0.001 to 1}
    \cgalParamDefault{0.1}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges, at which limbs stop (paper, 2.5); an estimate on a feature edge is that
    of one patch: of the widest around a vertex, or of the face of a `Face_location`}
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

\return a `Normal_curvature`
\throw std::invalid_argument if a parameter is out of its range, or a face that is met isn't a triangle

\sa `estimate_curvature()`
*/
template <typename Query,
          typename Normal,
          typename Direction,
          typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto estimate_normal_curvature(const Query& query,
                               const Normal& normal,
                               const Direction& direction,
                               const TriangleMesh& tmesh,
                               const NamedParameters& np = CGAL::parameters::default_values())
{
  using Inputs = internal::Mesh_inputs<TriangleMesh, NamedParameters>;
  using Scalar = typename Inputs::Scalar;
  using FT = typename Inputs::Result_traits::FT;
  const Inputs inputs(tmesh, np, section_fit);
  const internal::Query_point<Inputs> at(inputs, query);
  const auto [n, d] = internal::checked_tangent_frame<Scalar>(normal, direction);

  Normal_curvature<FT> result;
  if(at.site.rim.empty())
    return result;
  result.status = insufficient;
  if(!(at.radius > 0))
    return result;
  std::vector<internal::Sample<Scalar>> samples;
  internal::Spider_extent<Scalar> extent;
  const internal::Local_coordinates<Scalar> local(at.site.point, {n, d}, at.radius);
  internal::sample_direction(inputs.view, at.site, local, Scalar(0), inputs.options, samples, extent);
  const internal::Section<Scalar> section = internal::fit_section(samples, inputs.options.polynomial_degree);
  const Scalar curvature = section.curvature / at.radius; // which overflows on meshes as small as numbers get
  if(!section.determined || !std::isfinite(curvature))
    return result;
  result.status = extent.is_complete ? ok : partial;
  result.curvature = static_cast<FT>(curvature);
  result.tangent_slope = static_cast<FT>(section.slope);
  result.residual =
    static_cast<FT>(std::sqrt(section.squared_residuals / Scalar(section.number_of_samples)) * at.radius);
  return result;
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_ESTIMATE_NORMAL_CURVATURE_H
