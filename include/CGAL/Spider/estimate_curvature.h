// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_ESTIMATE_CURVATURE_H
#define CGAL_SPIDER_ESTIMATE_CURVATURE_H

#include <CGAL/Spider/Curvature_estimate_3.h>
#include <CGAL/Spider/estimate_normal.h>
#include <CGAL/Spider/internal/Spider_engine.h>
#include <CGAL/Spider/internal/continuous_reference.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// carries an estimate into the caller's kernel.
template <typename GT, typename Scalar>
Curvature_estimate_3<GT> to_result(const Estimate<Scalar>& estimate)
{
  using FT = typename GT::FT;
  using Vector_3 = typename GT::Vector_3;
  Curvature_estimate_3<GT> result;
  result.normal = from_vec3<Vector_3>(estimate.normal);
  result.status = estimate.status;
  result.coverage = static_cast<FT>(estimate.coverage);
  const FT min_curvature = static_cast<FT>(estimate.min_curvature);
  const FT max_curvature = static_cast<FT>(estimate.max_curvature);
  if(result.is_valid() && !(std::isfinite(min_curvature) && std::isfinite(max_curvature)))
    result.status = insufficient; // the mesh is so small that its curvature isn't a number of this type
  if(!result.is_valid())
    return result;
  result.min_curvature = min_curvature;
  result.max_curvature = max_curvature;
  result.min_direction = from_vec3<Vector_3>(estimate.min_direction);
  result.max_direction = from_vec3<Vector_3>(estimate.max_direction);
  result.residual = static_cast<FT>(estimate.residual);
  return result;
}

/// returns what the caller gets who gave one radius, or several in `radii`.
template <typename Inputs, typename Engine, typename View, typename Scalar>
auto estimate_at(const Site<View>& site,
                 Scalar radius,
                 const Radius_list<Scalar>& radii,
                 const Vec3<Scalar>& first_normal,
                 Engine& engine)
{
  using GT = typename Inputs::Result_traits;
  if constexpr(Inputs::has_radii)
  {
    std::vector<Estimate<Scalar>> estimates;
    engine(site, radii.ascending, first_normal, estimates);
    std::vector<Curvature_estimate_3<GT>> results;
    for(const std::size_t place : radii.places)
      results.push_back(to_result<GT>(estimates[place]));
    return results;
  }
  else
    return to_result<GT>(engine(site, radius, first_normal));
}

} // namespace internal

/*!
\ingroup PkgSpiderEstimation

estimates the normal and the principal curvatures at one point. For many points of one mesh
`estimate_vertex_curvatures()`, `estimate_curvatures()` and `Curvature_estimator` are faster.

In each round, all limbs of the spider are walked in the frame of the last normal, and from them come the principal
curvatures and the next normal:

- `surface_fit` fits one polynomial height field to a sample of each segment of all limbs, and takes curvatures and
  normal from its fundamental forms. Where only few vertices are in reach, both curvatures are the mean one;
- `section_fit` fits a polynomial along each direction, takes the orthogonal pair of directions whose curvatures differ
  most as the principal one, and the average of its two normals as the next normal (paper, 2.2 to 2.4). Pairs that differ
  nearly as much share in that average: on a smooth surface it stays the same, at a corner it doesn't depend on chance.

With `geodesic_radius` and `number_of_directions` given, it takes time linear in the number of faces crossed, whatever the
size of the mesh.

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
  \cgalParamNBegin{geodesic_radii}
    \cgalParamDescription{several radii instead of one: the result is one estimate for each, in their order}
    \cgalParamType{a range of numbers}
    \cgalParamDefault{none: `geodesic_radius` holds}
    \cgalParamExtra{`surface_fit` walks limbs once for all radii, but for places where the normals found differ much
    from the first one. All radii start from the same normal, that of their extremes' geometric mean, and have the
    directions of the largest, so that answers differ a little from those of one radius at a time}
  \cgalParamNEnd
  \cgalParamNBegin{limb_elongation_map}
    \cgalParamDescription{vectors along which limbs reach the radius, while across they reach as many times less as these are
    long, and an ellipse in between}
    \cgalParamType{a readable property map from vertices to vectors of any kernel; vectors of lengths up to 1, or that aren't
    finite, stand for a disc, and those above 8 count as 8}
    \cgalParamDefault{none: limbs reach equally far}
    \cgalParamExtra{`suggest_adaptive_radii()` finds them, together with the radii; with `section_fit` none may be longer than
    1; several `geodesic_radii` are then walked to one by one}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_directions}
    \cgalParamDescription{number of directions, spaced regularly over a half turn, with two limbs each}
    \cgalParamType{an integer from 3 to 65536; with `section_fit` an even one from 2}
    \cgalParamDefault{2.5 for each mean edge length of the radius, at least 16; with `section_fit` 64 (paper, 2.6)}
    \cgalParamExtra{the default takes a pass over all edges}
  \cgalParamNEnd
  \cgalParamNBegin{estimator}
    \cgalParamDescription{how samples become curvatures}
    \cgalParamType{`Spider::Estimator`}
    \cgalParamDefault{`Spider::surface_fit`}
    \cgalParamExtra{`Spider::section_fit` is the paper's; noise misleads it far more}
  \cgalParamNEnd
  \cgalParamNBegin{limb_measure}
    \cgalParamDescription{what is measured along a limb until it reaches the radius}
    \cgalParamType{`Spider::Limb_measure`}
    \cgalParamDefault{`Spider::tangential_distance`; with `section_fit` `Spider::arc_length` (the paper's)}
    \cgalParamExtra{by `tangential_distance` a limb that climbs a wall doesn't get on: it ends, and makes the estimate
    `partial`, when it is four radii long}
  \cgalParamNEnd
  \cgalParamNBegin{polynomial_degree}
    \cgalParamDescription{degree of the fitted polynomials}
    \cgalParamType{2, 3 or 4}
    \cgalParamDefault{2}
    \cgalParamExtra{`surface_fit` takes terms up to the fourth degree as far as noise lets, whatever the degree; those up
    to the degree are interpolated over facets as the mesh would have them. So under noise 3 and 4 are as good as 2, and
    on smooth meshes without noise and with small radii far better. They take up to twice the time}
  \cgalParamNEnd
  \cgalParamNBegin{resampling_step}
    \cgalParamDescription{distance of samples along a limb, as a share of the radius}
    \cgalParamType{a number from 0.001 to 1}
    \cgalParamDefault{0.1}
    \cgalParamExtra{of no effect on `surface_fit`, which samples each segment}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{most rounds in which the normal is found anew and the spider grown again from it}
    \cgalParamType{a positive integer}
    \cgalParamDefault{10}
    \cgalParamExtra{one round is enough where normals are reliable (paper, 2.6)}
  \cgalParamNEnd
  \cgalParamNBegin{convergence_angle}
    \cgalParamDescription{the iteration rests when the normal moves by no more than this angle, in radians}
    \cgalParamType{a number}
    \cgalParamDefault{0.3; with `section_fit` 0.001}
    \cgalParamExtra{a height field has its normal free, so only a large tilt needs another round; `surface_fit` also
    rests when a round fits worse than the one before, and from this angle to 4/3 of it takes a mean of two rounds, so
    that answers change little by little along the mesh}
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
    \cgalParamExtra{`surface_fit` has limbs stop at feature edges at any angle, since only one patch may enter a fit}
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

\return a `Curvature_estimate_3`, whose `status` says how it came about; with `geodesic_radii` a `std::vector` of them. It
never throws for what is wrong with a mesh locally: what can't be estimated is NaN.
\throw std::invalid_argument if a parameter is out of its range, or a face that is met isn't a triangle
*/
template <typename Query, typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto estimate_curvature(const Query& query,
                        const TriangleMesh& tmesh,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  using Inputs = internal::Mesh_inputs<TriangleMesh, NamedParameters>;
  const Inputs inputs(tmesh, np, surface_fit);
  internal::Query_point<Inputs> at(inputs, query);
  const auto normal = internal::first_normal_of_query(inputs, at);
  at.site.reference = internal::continuous_reference(inputs.view, at.site, normal,
                                                     inputs.options.number_of_directions_at(at.radius));
  if constexpr(Inputs::has_elongations)
    at.site.shortening = internal::interpolate(at.site, [&](auto v) { return internal::shortening_across(inputs.elongation_at(v)); });
  internal::Estimator_engine<typename Inputs::View> engine(inputs.view, inputs.options);
  return internal::estimate_at<Inputs>(at.site, at.radius, inputs.radii, normal, engine);
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_ESTIMATE_CURVATURE_H
