// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_SMOOTH_BY_GEODESIC_RINGS_H
#define CGAL_SPIDER_SMOOTH_BY_GEODESIC_RINGS_H

#include <CGAL/Spider/internal/Mesh_inputs.h>
#include <CGAL/Spider/internal/Ring_smoother.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderClasses

What `smooth_by_geodesic_rings()` did. Lengths and volumes are in the mesh's units.

\tparam FT a floating-point number type
*/
template <typename FT>
struct Smoothing_result
{
  int number_of_iterations = 0; ///< rounds that took place
  FT greatest_displacement = 0; ///< distance between a vertex' first and last place, the greatest of all vertices
  FT mean_displacement = 0;     ///< the same, on average over all vertices
  FT volume_before = 0; ///< what the mesh enclosed, positive if its faces point outwards; NaN if it isn't closed
  FT volume_after = 0;  ///< what it encloses now
};

/*!
\ingroup PkgSpiderSmoothing

smooths a mesh (paper, 3.1): each round moves every vertex by a share of the way to the centroid of its geodesic ring,
that is, of the ends of its limbs. A ring samples the surface around a vertex evenly, however its faces are shaped, so
unlike Laplacian smoothing this doesn't drift towards where vertices are dense.

All vertices of a round move at once. Where a face would turn over or degenerate, its vertices move by a half of their
way, a quarter, and so on to nothing. A round takes time linear in the number of vertices and in the faces that limbs
cross.

\tparam ConcurrencyTag `CGAL::Sequential_tag` (the default), `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`;
        the outcome is the same to the last bit
\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a triangle mesh; its vertices are moved
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{geodesic_radius}
    \cgalParamDescription{the radius of the rings: larger ones smooth more, and blur more}
    \cgalParamType{a number, or a readable property map from vertices to numbers}
    \cgalParamDefault{half of the mean edge length of the mesh (the paper's, figure 11), or where the edges around a
    vertex are shorter on average, half of that; if volume is kept, from round to round up to three times as much where
    what the vertices do tells of noise rather than of shape, as far as borders and feature edges leave room}
    \cgalParamExtra{so rings don't blur shape, and take noise off where there is nothing to blur}
  \cgalParamNEnd
  \cgalParamNBegin{smoothing_factor}
    \cgalParamDescription{the share of the way to the ring's centroid that a vertex goes in a round}
    \cgalParamType{a number greater than 0 and at most 1}
    \cgalParamDefault{0.2}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{most rounds}
    \cgalParamType{a positive integer}
    \cgalParamDefault{10}
  \cgalParamNEnd
  \cgalParamNBegin{convergence_displacement}
    \cgalParamDescription{a length: the rounds end with the first in which no vertex moves farther}
    \cgalParamType{a number that is not negative}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_directions}
    \cgalParamDescription{directions over a half turn; two limbs each}
    \cgalParamType{an even number from 2 to 65536}
    \cgalParamDefault{16}
  \cgalParamNEnd
  \cgalParamNBegin{ring_weight}
    \cgalParamDescription{how the points of a ring count for its centroid}
    \cgalParamType{`Spider::Ring_weight`}
    \cgalParamDefault{`Spider::by_limb` (the paper's)}
  \cgalParamNEnd
  \cgalParamNBegin{limb_measure}
    \cgalParamDescription{what is measured along a limb until it reaches the radius}
    \cgalParamType{`Spider::Limb_measure`}
    \cgalParamDefault{`Spider::arc_length` (the paper's)}
  \cgalParamNEnd
  \cgalParamNBegin{keep_volume}
    \cgalParamDescription{whether vertices take back in every round what those around them move alike, by which curved
    parts would shrink, and go no farther from where they were than one and a half times the root mean square of how
    far vertices nearby went; and then all free vertices step along their normals by one length, by which a closed mesh
    encloses as much as at first}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true` (the paper's: `false`)}
    \cgalParamExtra{such steps leave constrained vertices where they are, which scaling the mesh would not}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{the vertices that stay where they are}
    \cgalParamType{a readable property map from vertices to `bool`}
    \cgalParamDefault{no vertices}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{feature edges: limbs stop there, and `line_motion` says what their vertices do}
    \cgalParamType{a readable property map from edges to `bool`}
    \cgalParamDefault{no edges}
  \cgalParamNEnd
  \cgalParamNBegin{line_motion}
    \cgalParamDescription{what vertices on borders and on constrained edges do}
    \cgalParamType{`Spider::Line_motion`}
    \cgalParamDefault{`Spider::fixed_lines`}
  \cgalParamNEnd
  \cgalParamNBegin{growth_cost_map}
    \cgalParamDescription{by how much length in a face counts}
    \cgalParamType{a readable property map from faces to numbers of at least 1}
    \cgalParamDefault{1 for all faces}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a read-write property map from vertices to points}
    \cgalParamDefault{`get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{the kernel; the result is in its numbers where they are floating-point}
    \cgalParamType{a \cgal kernel}
    \cgalParamDefault{deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return a `Smoothing_result`
\throw std::invalid_argument if a parameter is out of its range, or a face isn't a triangle
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto smooth_by_geodesic_rings(TriangleMesh& tmesh, const NamedParameters& np = CGAL::parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Inputs = internal::Mesh_inputs<TriangleMesh, NamedParameters>;
  using Scalar = typename Inputs::Scalar;
  using Traits = boost::graph_traits<TriangleMesh>;
  using FT = typename Inputs::Result_traits::FT;

  const Inputs inputs(tmesh, np, section_fit, internal::whole_star);
  const internal::Ranks<typename Traits::vertex_descriptor> vertex_ranks(vertices(tmesh));
  const internal::Ranks<typename Traits::face_descriptor> face_ranks(faces(tmesh));
  internal::Mesh_snapshot<Scalar> mesh(tmesh, inputs.view, vertex_ranks, face_ranks);

  std::vector<Scalar> radii(vertex_ranks.size());
  std::vector<bool> is_fixed(vertex_ranks.size(), false);
  const auto constrained = get_parameter(np, CGAL::internal_np::vertex_is_constrained);
  for(std::size_t v = 0; v < vertex_ranks.size(); ++v)
  {
    radii[v] = Inputs::has_radius ? inputs.radius_at(vertex_ranks[v])
                                  : std::min(internal::mean_edge_length_at(mesh, static_cast<std::uint32_t>(v)),
                                             inputs.options.mean_edge_length) /
                                      2;
    if constexpr(internal::is_given<decltype(constrained)>)
      is_fixed[v] = get(constrained, vertex_ranks[v]);
  }

  const internal::Smoothing_options<Scalar> options(np, inputs.options);
  const std::vector<internal::Vec3<Scalar>> first_points = mesh.points();
  internal::Ring_smoother<Scalar> smoother(mesh, options, std::move(radii), is_fixed, CGAL::is_closed(tmesh));
  const auto done = smoother.template run<ConcurrencyTag>();

  auto points =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_property_map(CGAL::vertex_point, tmesh));
  using Point = typename boost::property_traits<decltype(points)>::value_type;
  for(std::size_t v = 0; v < vertex_ranks.size(); ++v)
    if(mesh.points()[v] != first_points[v])
      put(points, vertex_ranks[v], internal::from_vec3<Point>(mesh.points()[v]));
  return Smoothing_result<FT>{done.number_of_iterations, static_cast<FT>(done.greatest_displacement),
                              static_cast<FT>(done.mean_displacement), static_cast<FT>(done.volume_before),
                              static_cast<FT>(done.volume_after)};
}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_SMOOTH_BY_GEODESIC_RINGS_H
