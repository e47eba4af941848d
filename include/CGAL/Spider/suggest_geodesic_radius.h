// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_SUGGEST_GEODESIC_RADIUS_H
#define CGAL_SPIDER_SUGGEST_GEODESIC_RADIUS_H

#include <CGAL/Spider/internal/Radius_ladder.h>
#include <CGAL/Spider/internal/local_radii.h>

#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// Where nothing tells radii apart, as on a plane: that which the other functions take where none is given.
constexpr double undecided_radius_in_edges = 4;

} // namespace internal

/*!
\ingroup PkgSpiderEstimation

suggests a geodesic radius for the estimation of curvature on a mesh: one at which noise and what curvature loses by
blurring are in balance, from 2 to 16 mean edge lengths.

At a sample of some hundred vertices, mean curvature is estimated with up to seven radii. Noise is told from what the
answers of small radii differ by, and blurring from what those of large radii differ by; the user manual has the
algebra, and how close that comes. The answer depends on the mesh alone, is the same whenever it is asked for, and scales with the mesh.
Beside a pass over the mesh, the time doesn't depend on the mesh's size.

\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a triangle mesh; it is only read
\param np an optional sequence of named parameters, those that `estimate_curvature()` will be called with; a
`geodesic_radius` among them is of no effect

\return a length in the mesh's units, of the floating-point type of `Curvature_estimate_3`: 4 mean edge lengths where
nothing can be told, as on a plane or on a mesh of few vertices; NaN for a mesh without faces or without an edge of
finite, positive length.
\throw std::invalid_argument if a parameter is out of its range, or a face isn't a triangle
*/
template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto suggest_geodesic_radius(const TriangleMesh& tmesh,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  using Ladder = internal::Radius_ladder<TriangleMesh, NamedParameters>;
  using Scalar = typename Ladder::Scalar;
  using FT = typename Ladder::Result_traits::FT;

  const Ladder ladder(tmesh, np);
  const Scalar edge_length = ladder.mean_edge_length();
  const auto candidates = ladder.vertices_of_faces();
  if(candidates.empty() || !(edge_length > 0))
    return static_cast<FT>(internal::nan<Scalar>());
  const auto radius =
    ladder.template best_radius<CGAL::Sequential_tag>(candidates, [&](std::uint32_t) { return edge_length; });
  return static_cast<FT>(edge_length * radius.value_or(Scalar(internal::undecided_radius_in_edges)));
}

/*!
\ingroup PkgSpiderEstimation

suggests a geodesic radius for each vertex, as `suggest_geodesic_radius()` does for all together: for meshes whose
vertices are dense in some places and sparse in others.

Vertices are sorted into classes by the length of the edges around them, one class for each time that it doubles. Each
class gets the radius in edge lengths that is best for it, from a sample of its own, and between classes it is
interpolated; so the radius follows the density of vertices.

\tparam ConcurrencyTag `CGAL::Sequential_tag` (the default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`;
        the answers are the same to the last bit
\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam VertexRadiusMap a model of `WritablePropertyMap` from vertices to a floating-point type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a triangle mesh; it is only read
\param vertex_radius_map takes the radii; if it is readable too, it is what `geodesic_radius()` may be given. A vertex
gets NaN where it has no edges of finite, positive length
\param np an optional sequence of named parameters, those that `estimate_curvature()` will be called with; a
`geodesic_radius` among them is of no effect

\throw std::invalid_argument if a parameter is out of its range, or a face isn't a triangle
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename TriangleMesh,
          typename VertexRadiusMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void suggest_geodesic_radii(const TriangleMesh& tmesh,
                            VertexRadiusMap vertex_radius_map,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  using Ladder = internal::Radius_ladder<TriangleMesh, NamedParameters>;
  using Scalar = typename Ladder::Scalar;
  using FT = typename boost::property_traits<VertexRadiusMap>::value_type;

  const Ladder ladder(tmesh, np);
  const std::vector<Scalar> edge_lengths = internal::local_edge_lengths(ladder.mesh());
  auto radii = internal::best_radii<ConcurrencyTag>(ladder, edge_lengths);
  if(radii.empty())
    radii.add(Scalar(1), Scalar(internal::undecided_radius_in_edges));
  for(std::uint32_t v = 0; v < edge_lengths.size(); ++v)
    put(vertex_radius_map, ladder.vertex(v), static_cast<FT>(edge_lengths[v] * radii(edge_lengths[v])));
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_SUGGEST_GEODESIC_RADIUS_H
