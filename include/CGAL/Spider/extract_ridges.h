// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_EXTRACT_RIDGES_H
#define CGAL_SPIDER_EXTRACT_RIDGES_H

#include <CGAL/Spider/Ridge_3.h>
#include <CGAL/Spider/internal/Extremality.h>
#include <CGAL/Spider/internal/Graph_view.h>
#include <CGAL/Spider/internal/Line_builder.h>
#include <CGAL/Spider/internal/Mesh_inputs.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// calls `visit(crossings, is_closed)` for each line of zero extremality that is a ridge, with its crossings in order.
template <typename View, typename TriangleMesh, typename Visitor>
void for_each_ridge(const Extremality<View, TriangleMesh>& extremality, const TriangleMesh& tmesh, Visitor&& visit)
{
  using Halfedge = typename View::Halfedge;
  auto is_done = get(CGAL::dynamic_face_property_t<bool>(), tmesh);
  for(const auto f : faces(tmesh))
    put(is_done, f, false);

  // goes on from a crossing to the end of the line, or to the face where it started
  const auto walk = [&](Halfedge crossing) {
    std::vector<Halfedge> line;
    for(; crossing != View::null_halfedge(); crossing = extremality.next(crossing))
    {
      const auto f = bgl::face_of(crossing, tmesh);
      if(!line.empty() && get(is_done, f))
        return std::make_pair(line, true);
      put(is_done, f, true);
      line.push_back(crossing);
    }
    return std::make_pair(line, false);
  };

  for(const auto f : faces(tmesh))
  {
    if(get(is_done, f))
      continue;
    std::vector<Halfedge> exits;
    for(const Halfedge h : CGAL::halfedges_around_face(bgl::halfedge_of(f, tmesh), tmesh))
      if(extremality.is_crossing(h))
        exits.push_back(h);
    if(exits.empty())
      continue;
    auto [line, is_closed] = walk(exits[0]);
    if(!is_closed)
    {
      const std::vector<Halfedge> back = walk(exits[1]).first;
      std::vector<Halfedge> whole;
      std::transform(back.rbegin(), back.rend(), std::back_inserter(whole),
                     [&](Halfedge h) { return bgl::opposite_of(h, tmesh); });
      whole.insert(whole.end(), line.begin(), line.end());
      line.swap(whole);
    }
    visit(line, is_closed);
  }
}

/// adds up what a ridge has of strength and sharpness along its segments.
template <typename Ridge, typename Extremality, typename View>
void measure(Ridge& line, const Extremality& extremality, const View& view)
{
  using Scalar = typename View::Scalar;
  Scalar length = 0, strength = 0, sharpness = 0;
  for(std::size_t i = 0; i + 1 < line.points.size(); ++i)
  {
    const auto in_face = extremality.in_face(view.halfedge(line.locations[i].first));
    const Scalar segment = (to_vec3<Scalar>(line.points[i + 1]) - to_vec3<Scalar>(line.points[i])).norm();
    length += segment;
    strength += segment * in_face.curvature;
    sharpness += segment * in_face.sharpness;
  }
  line.strength = static_cast<typename Ridge::FT>(strength);
  line.sharpness = static_cast<typename Ridge::FT>(sharpness / length);
}

/// returns how often gradients are averaged over neighbours: until over about a third of the radius.
template <typename Scalar>
int passes_within(Scalar radius_in_edges)
{
  constexpr Scalar edges_of_first_pass = 2; // a pass spreads by 0.65 edges along each axis; n passes by √n as much
  constexpr Scalar most_passes = 256;       // for a radius of 32 edges
  const Scalar share = radius_in_edges / edges_of_first_pass, passes = std::round(share * share);
  return passes < most_passes ? static_cast<int>(passes) : static_cast<int>(most_passes);
}

} // namespace internal

/*!
\ingroup PkgSpiderUses

extracts the ridges and valleys of a surface as polylines on the mesh: the lines along which a principal curvature is
extremal in its own direction (Ohtake, Belyaev and Seidel 2004). Along a ridge, `max_curvature` is greatest across the
line, and greater than the absolute value of `min_curvature`; along a valley, `min_curvature` is least, and below minus
the absolute value of `max_curvature`. A mesh turned inside out has the same lines, ridges for valleys.

The derivatives are those of the estimates from vertex to vertex, averaged over about a third of the radius of the
estimates: nearer, estimates differ by their errors more than by the surface. So the radius is what keeps noise out of
the lines, and ridges want a larger one than isolines do. What noise leaves is short or hardly sharper than what is
beside it, and is left out by the two thresholds.

Lines end at borders, where there is no finite estimate, where a line ceases to be a ridge, and at umbilics, where
principal directions don't agree. They neither branch nor cross. It takes time linear in the size of the mesh, and in
the square of the radius in units of the mean edge length.

\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam CurvatureMap a model of `ReadablePropertyMap` from vertices to `Curvature_estimate_3`, or to another class with
        its members `min_curvature`, `max_curvature`, `min_direction` and `max_direction`
\tparam OutputIterator an output iterator that takes `Ridge_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a triangle mesh; it is only read
\param curvature_map the estimates, which are read once for each vertex and each of the two kinds of lines
\param out takes the lines, ridges first
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{geodesic_radius}
    \cgalParamDescription{the radius of the estimates}
    \cgalParamType{a number}
    \cgalParamDefault{four times the mean edge length, as for the estimates}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_strength}
    \cgalParamDescription{lines of less `Ridge_3::strength` are left out}
    \cgalParamType{a number that is not negative}
    \cgalParamDefault{1: lines that are shorter than the radius of curvature across them are left out}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_sharpness}
    \cgalParamDescription{lines of less `Ridge_3::sharpness` are left out}
    \cgalParamType{a number that is not negative}
    \cgalParamDefault{0.5: lines across which curvature falls off by less than a quarter within its radius are left out}
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

\return the output iterator behind the last line
\throw std::invalid_argument if a threshold is negative or isn't finite, or a face isn't a triangle

\sa `extract_isolines()`
*/
template <typename TriangleMesh, typename CurvatureMap, typename OutputIterator,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator extract_ridges(const TriangleMesh& tmesh, CurvatureMap curvature_map, OutputIterator out,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using GT = typename CGAL::GetGeomTraits<TriangleMesh, NamedParameters>::type;
  using Vertex_point_map = typename CGAL::GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using View = internal::Graph_view<TriangleMesh, Vertex_point_map>;
  using Scalar = typename View::Scalar;
  using Across = internal::Curvature_across<Scalar>;
  using Extremality = internal::Extremality<View, TriangleMesh>;
  using Ridge = Ridge_3<TriangleMesh, internal::Result_kernel<GT>>;

  const View view(tmesh, choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, tmesh)));
  Scalar radius_in_edges = 4; // the default of the estimates
  const auto given_radius = get_parameter(np, Spider::internal_np::geodesic_radius);
  if constexpr(internal::is_given<decltype(given_radius)>)
  {
    const auto radius = internal::to_scalar<Scalar>(given_radius);
    internal::check_radius(radius);
    radius_in_edges = radius / internal::mean_edge_length(view, tmesh);
  }
  constexpr Scalar default_strength = 1, default_sharpness = Scalar(0.5);
  const auto minimum_strength = internal::to_scalar<Scalar>(
    choose_parameter(get_parameter(np, Spider::internal_np::minimum_strength), default_strength));
  const auto minimum_sharpness = internal::to_scalar<Scalar>(
    choose_parameter(get_parameter(np, Spider::internal_np::minimum_sharpness), default_sharpness));
  internal::check_parameter(minimum_strength >= 0 && std::isfinite(minimum_strength), "minimum_strength",
                            minimum_strength, "give a finite number that is not negative");
  internal::check_parameter(minimum_sharpness >= 0 && std::isfinite(minimum_sharpness), "minimum_sharpness",
                            minimum_sharpness, "give a finite number that is not negative");
  internal::check_is_triangulated(view, tmesh);

  const auto extract = [&](Ridge_kind kind, auto&& curvature_at) {
    const Extremality extremality(view, tmesh, curvature_at, internal::passes_within(radius_in_edges));
    internal::for_each_ridge(extremality, tmesh, [&](const auto& crossings, bool is_closed) {
      const internal::Line_builder<Extremality, Ridge> builder(extremality, crossings, is_closed);
      if(!builder.is_line())
        return;
      Ridge line = builder.line();
      line.kind = kind;
      internal::measure(line, extremality, view);
      if(line.strength >= minimum_strength && line.sharpness >= minimum_sharpness)
        *out++ = std::move(line);
    });
  };
  const auto number = [](const auto& x) { return internal::to_scalar<Scalar>(x); };
  extract(ridge, [&](const auto& v) {
    const auto& e = get(curvature_map, v);
    return Across{number(e.max_curvature), number(e.min_curvature), internal::to_vec3<Scalar>(e.max_direction)};
  });
  extract(valley, [&](const auto& v) { // the ridges of the mesh turned inside out
    const auto& e = get(curvature_map, v);
    return Across{-number(e.min_curvature), -number(e.max_curvature), internal::to_vec3<Scalar>(e.min_direction)};
  });
  return out;
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_EXTRACT_RIDGES_H
