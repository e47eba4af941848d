// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_SUGGEST_ADAPTIVE_RADII_H
#define CGAL_SPIDER_SUGGEST_ADAPTIVE_RADII_H

#include <CGAL/Spider/internal/adaptive_limbs.h>
#include <CGAL/Spider/suggest_geodesic_radius.h>

#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderEstimation

suggests a geodesic radius for each vertex that adapts to the shape, from 2 to 8 times the length of the edges around it:
small where the surface bends at a small scale, large where it doesn't. It is for meshes that have both, as ears and a
body; where only the density of vertices varies, `suggest_geodesic_radii()` is faster, and goes up to 16 edge lengths.

At a tenth of the vertices, or at more of a small mesh, curvature is estimated with five radii in one walk.
Noise is told by what the answers of the smallest radii differ by where the surface is smooth; vertices whose edges are
up to four times as long as others' share it. What answers differ by in a neighbourhood beyond that is blurring. The user
manual has the algebra, and where it is better than any one radius, and where it isn't.

Given a `limb_elongation_map`, limbs adapt by direction, too: along a ridge they may be longer than across it. It takes a
vector for each vertex, as the functions that estimate curvature read it: along it limbs are up to twice as long as across.
An ellipse has the area of the disc that it is in place of, so that radii, which are those of the longest limbs, are up to
1.42 times as large as without. Radii and vectors go together: give the functions that estimate both.

It takes linear time: see the user manual for how much.

\tparam ConcurrencyTag `CGAL::Sequential_tag` (the default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`;
        the answers are the same to the last bit
\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam VertexRadiusMap a model of `WritablePropertyMap` from vertices to a floating-point type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a triangle mesh; it is only read
\param vertex_radius_map takes the radii; if it is readable too, it is what `geodesic_radius()` may be given. A vertex
gets NaN where it has no edges of finite, positive length
\param np an optional sequence of named parameters, those that `estimate_curvature()` will be called with; a
`geodesic_radius` among them is of no effect, and a `limb_elongation_map`, a model of `WritablePropertyMap` from vertices to
vectors, is written

\throw std::invalid_argument if a parameter is out of its range, or a face isn't a triangle
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename TriangleMesh,
          typename VertexRadiusMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void suggest_adaptive_radii(const TriangleMesh& tmesh,
                            VertexRadiusMap vertex_radius_map,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  using Ladder = internal::Radius_ladder<TriangleMesh, NamedParameters>;
  using Scalar = typename Ladder::Scalar;
  using FT = typename boost::property_traits<VertexRadiusMap>::value_type;
  const auto elongation_map = parameters::get_parameter(np, internal_np::limb_elongation_map);
  using Elongation_map = std::decay_t<decltype(elongation_map)>;
  constexpr bool elongate = internal::is_given<Elongation_map>;

  const Ladder ladder(tmesh, np);
  const auto limbs = internal::adaptive_limbs<ConcurrencyTag>(
    ladder, static_cast<Scalar>(internal::undecided_radius_in_edges), elongate);
  for(std::uint32_t v = 0; v < limbs.radii.size(); ++v)
  {
    put(vertex_radius_map, ladder.vertex(v), static_cast<FT>(limbs.radii[v]));
    if constexpr(elongate)
    {
      using Vector = typename boost::property_traits<Elongation_map>::value_type;
      put(elongation_map, ladder.vertex(v), internal::from_vec3<Vector>(limbs.elongations[v]));
    }
  }
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_SUGGEST_ADAPTIVE_RADII_H
