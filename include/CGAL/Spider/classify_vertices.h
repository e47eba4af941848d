// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_CLASSIFY_VERTICES_H
#define CGAL_SPIDER_CLASSIFY_VERTICES_H

#include <CGAL/Spider/internal/Graph_view.h>
#include <CGAL/Spider/internal/Mesh_inputs.h>
#include <CGAL/Spider/internal/typical_curvature.h>

#include <CGAL/IO/Color.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <ostream>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderUses

How a surface bends at a vertex, as seen from the side to which the faces point (paper, figure 10a).
*/
enum Vertex_label
{
  convex,    ///< as a cap or a ridge: away from the normal in one direction at least, and towards it in none
  concave,   ///< as a cup or a rut: towards the normal in one direction at least, and away from it in none
  flat,      ///< hardly at all
  saddle,    ///< away from the normal in one direction, and towards it in another
  unlabelled ///< there is no estimate
};

/// \ingroup PkgSpiderUses
/// writes the name of a label.
inline std::ostream& operator<<(std::ostream& out, Vertex_label label)
{
  switch(label)
  {
    case convex: return out << "convex";
    case concave: return out << "concave";
    case flat: return out << "flat";
    case saddle: return out << "saddle";
    default: return out << "unlabelled";
  }
}

/// \ingroup PkgSpiderUses
/// returns a colour for a label: the paper's for convex (green), concave (yellow) and flat (blue), in shades that
/// colour-blind readers tell apart (Okabe and Ito), vermilion for saddles, and grey without a label.
inline CGAL::IO::Color label_color(Vertex_label label)
{
  switch(label)
  {
    case convex: return CGAL::IO::Color(0, 158, 115);
    case concave: return CGAL::IO::Color(240, 228, 66);
    case flat: return CGAL::IO::Color(0, 114, 178);
    case saddle: return CGAL::IO::Color(213, 94, 0);
    default: return CGAL::IO::Color(128, 128, 128);
  }
}

namespace internal {

template <typename Scalar>
Vertex_label label_of(Scalar min_curvature, Scalar max_curvature, Scalar threshold)
{
  if(!std::isfinite(min_curvature) || !std::isfinite(max_curvature) || std::isnan(threshold))
    return unlabelled;
  const bool bends_away = max_curvature > threshold, bends_towards = min_curvature < -threshold;
  return bends_away ? bends_towards ? saddle : convex : bends_towards ? concave : flat;
}

} // namespace internal

/*!
\ingroup PkgSpiderUses

labels vertices as convex, concave, flat or saddle by their principal curvatures (paper, figure 10a). A principal
curvature counts as positive above the threshold, as negative below minus the threshold, and as none in between. So a
ridge is convex, and a rut is concave.

Unless the threshold is given, it is three quarters of the typical curvature: the mean over the area, without the most
curved 5 % of it, of the larger of the two principal curvatures' absolute values. A mean over the area depends on the
surface, and little on how it is meshed; a sphere or a cylinder is convex all over; and neither a few wild estimates
nor small, sharp details move it. It grows and shrinks with the mesh, and is never less than what bends the whole
surface by a ten-thousandth of its extent. Labels of several meshes compare only if they have one threshold, and on a
surface that is flat but for noise no other than a given threshold tells noise from shape.

It takes time in O(n log n), n the number of vertices, and linear time with a threshold given.

\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam CurvatureMap a model of `ReadablePropertyMap` from vertices to a model of `SpiderPrincipalCurvatures`, such as
        `Curvature_estimate_3`
\tparam LabelMap a model of `WritablePropertyMap` from vertices to `Vertex_label`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a triangle mesh; it is only read
\param curvature_map the estimates
\param label_map takes the labels: `unlabelled` where a curvature isn't finite
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{flatness_threshold}
    \cgalParamDescription{the largest absolute value, a reciprocal length, of a curvature that counts as none}
    \cgalParamType{a number}
    \cgalParamDefault{three quarters of the typical curvature, as above}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a readable property map from vertices to points}
    \cgalParamDefault{`get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the threshold; NaN if it isn't given and no vertex has an estimate
\throw std::invalid_argument if the threshold is negative or isn't finite, or a face isn't a triangle

\sa `extract_isolines()`
*/
template <typename TriangleMesh,
          typename CurvatureMap,
          typename LabelMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto classify_vertices(const TriangleMesh& tmesh,
                       CurvatureMap curvature_map,
                       LabelMap label_map,
                       const NamedParameters& np = CGAL::parameters::default_values())
{
  using Vertex_point_map = typename CGAL::GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using View = internal::Graph_view<TriangleMesh, Vertex_point_map>;
  using Scalar = typename View::Scalar;
  const View view(tmesh, parameters::choose_parameter(parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                                      get_const_property_map(CGAL::vertex_point, tmesh)));

  const auto given = parameters::get_parameter(np, Spider::internal_np::flatness_threshold);
  Scalar threshold;
  if constexpr(internal::is_given<decltype(given)>)
  {
    threshold = internal::to_scalar<Scalar>(given);
    internal::check_parameter(threshold >= 0 && std::isfinite(threshold), "flatness_threshold", threshold,
                              "give a finite curvature that is not negative");
  }
  else
    threshold = internal::default_flatness_threshold(view, tmesh, curvature_map);

  for(const auto v : vertices(tmesh))
  {
    const auto& estimate = get(curvature_map, v);
    put(label_map, v,
        internal::label_of(internal::to_scalar<Scalar>(estimate.min_curvature),
                           internal::to_scalar<Scalar>(estimate.max_curvature), threshold));
  }
  return threshold;
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_CLASSIFY_VERTICES_H
