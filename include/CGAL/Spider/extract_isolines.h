// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_EXTRACT_ISOLINES_H
#define CGAL_SPIDER_EXTRACT_ISOLINES_H

#include <CGAL/Spider/Isoline_3.h>
#include <CGAL/Spider/internal/Graph_view.h>
#include <CGAL/Spider/internal/Level_set.h>
#include <CGAL/Spider/internal/Line_builder.h>
#include <CGAL/Spider/internal/Mesh_inputs.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderUses

extracts the isolines of a scalar: the polylines on the mesh along which the scalar, given at the vertices and linear in
each face, has the value `value` (paper, figure 10b).

They are the outline of the part of the surface where the scalar is at least `value`, and have it on their left, as seen
from the side to which the faces point. What that means where the value is hit exactly:

- an isoline may run through vertices and along edges, and around faces that have the value all over;
- a peak, a ridge or a piece of border that has the value itself, with less beside it, gives no line, nor does a pit or
a valley: no line degenerates to a point, and no segment is drawn twice;
- where several lines meet in a vertex each passes through: lines may touch, but don't cross or branch.

Lines end at borders, and at faces with a corner where the scalar is infinite or not a number. All others are closed.
It takes time linear in the size of the mesh.

\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam ScalarMap a model of `ReadablePropertyMap` from vertices to numbers of any type
\tparam Value a type of numbers
\tparam OutputIterator an output iterator that takes `Isoline_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a triangle mesh; it is only read
\param scalar_map the scalar, which is read once for each vertex
\param value the value that the scalar has along the lines
\param out takes the lines, those with ends first
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
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

\return the output iterator behind the last line
\throw std::invalid_argument if `value` isn't finite, or a face isn't a triangle

\sa `classify_vertices()`
*/
template <typename TriangleMesh, typename ScalarMap, typename Value, typename OutputIterator,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator extract_isolines(const TriangleMesh& tmesh, ScalarMap scalar_map, const Value& value, OutputIterator out,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  using GT = typename CGAL::GetGeomTraits<TriangleMesh, NamedParameters>::type;
  using Vertex_point_map = typename CGAL::GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using View = internal::Graph_view<TriangleMesh, Vertex_point_map>;
  using Isoline = Isoline_3<TriangleMesh, internal::Result_kernel<GT>>;

  const View view(tmesh, parameters::choose_parameter(parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                                      get_const_property_map(CGAL::vertex_point, tmesh)));
  const auto level = internal::to_scalar<typename View::Scalar>(value);
  internal::check_parameter(std::isfinite(level), "value", level, "give a finite number");
  internal::check_is_triangulated(view, tmesh);

  using Level_set = internal::Level_set<View, TriangleMesh>;
  const Level_set level_set(view, tmesh, scalar_map, level);
  internal::for_each_line(level_set, tmesh, [&](const auto& crossings, bool is_closed) {
    const internal::Line_builder<Level_set, Isoline> builder(level_set, crossings, is_closed);
    if(builder.is_line())
      *out++ = builder.line();
  });
  return out;
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_EXTRACT_ISOLINES_H
