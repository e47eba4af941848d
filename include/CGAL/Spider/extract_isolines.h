// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_EXTRACT_ISOLINES_H
#define CGAL_SPIDER_EXTRACT_ISOLINES_H

#include <CGAL/Spider/Isoline_3.h>
#include <CGAL/Spider/internal/Graph_view.h>
#include <CGAL/Spider/internal/Level_set.h>
#include <CGAL/Spider/internal/Options.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// Gathers the crossings of one line into points: crossings that follow one another at the same place are one point.
template <typename LevelSet, typename Isoline>
class Isoline_builder
{
  using Halfedge = typename LevelSet::Halfedge;
  using FT = typename Isoline::FT;
  using Point_3 = typename Isoline::Point_3;

  struct Node
  {
    Point_3 point;
    Halfedge first, last; ///< of the crossings that are at this point
  };

public:
  Isoline_builder(const LevelSet& level_set, const std::vector<Halfedge>& crossings, bool is_closed)
    : level_set_(level_set), is_closed_(is_closed)
  {
    for(const Halfedge crossing : crossings)
    {
      const Point_3 point = from_vec3<Point_3>(level_set.point(crossing));
      if(!nodes_.empty() && nodes_.back().point == point)
        nodes_.back().last = crossing;
      else
        nodes_.push_back({point, crossing, crossing});
    }
    if(is_closed)
      close();
  }

  /// tells whether there is a line: not just a point, nor a segment and the way back.
  bool is_line() const { return nodes_.size() >= (is_closed_ ? 4 : 2); }

  Isoline isoline() const
  {
    Isoline result;
    result.is_closed = is_closed_;
    for(const Node& node : nodes_)
    {
      const bool is_end = &node == &nodes_.back();
      const auto [f, weights] = is_end ? level_set_.location_behind(node.first) : level_set_.location_ahead(node.last);
      result.points.push_back(node.point);
      result.locations.push_back(
        {f, {static_cast<FT>(weights[0]), static_cast<FT>(weights[1]), static_cast<FT>(weights[2])}});
    }
    return result;
  }

private:
  /// joins the end to the start, which is repeated.
  void close()
  {
    if(nodes_.size() > 1 && nodes_.back().point == nodes_.front().point)
    {
      nodes_.front().first = nodes_.back().first;
      nodes_.pop_back();
    }
    nodes_.push_back(Node(nodes_.front()));
  }

  const LevelSet& level_set_;
  bool is_closed_;
  std::vector<Node> nodes_;
};

template <typename View, typename TriangleMesh>
void check_is_triangulated(const View& view, const TriangleMesh& tmesh)
{
  for(const auto f : faces(tmesh))
    view.other_edges(view.halfedge(f)); // throws
}

} // namespace internal

/*!
\ingroup PkgSpiderUses

extracts the isolines of a scalar: the polylines on the mesh along which the scalar, given at the vertices and linear in
each face, has the value `value` (paper, figure 10b).

They are the outline of the part of the surface where the scalar is at least `value`, and have it on their left, as seen
from the side to which the faces point. What that means where the value is hit exactly:

- an isoline may run through vertices and along edges, and around faces that have the value all over;
- a peak, a ridge or a piece of border that has the value itself, with less beside it, gives no line, nor does a pit or a
  valley: no line degenerates to a point, and no segment is drawn twice;
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
template <typename TriangleMesh,
          typename ScalarMap,
          typename Value,
          typename OutputIterator,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator extract_isolines(const TriangleMesh& tmesh,
                                ScalarMap scalar_map,
                                const Value& value,
                                OutputIterator out,
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
    const internal::Isoline_builder<Level_set, Isoline> builder(level_set, crossings, is_closed);
    if(builder.is_line())
      *out++ = builder.isoline();
  });
  return out;
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_EXTRACT_ISOLINES_H
