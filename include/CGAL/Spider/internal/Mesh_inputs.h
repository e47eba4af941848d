// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh and the named parameters that come with it: what the public functions start from.

#ifndef CGAL_SPIDER_INTERNAL_MESH_INPUTS_H
#define CGAL_SPIDER_INTERNAL_MESH_INPUTS_H

#include <CGAL/Spider/internal/Graph_view.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Radius_list.h>
#include <CGAL/Spider/internal/Site.h>
#include <CGAL/Spider/internal/first_normal.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Spider {
namespace internal {

template <typename T>
constexpr bool is_number =
  !std::is_same<typename CGAL::Algebraic_structure_traits<T>::Algebraic_category, CGAL::Null_tag>::value;

/// throws unless all faces are triangles.
template <typename View, typename TriangleMesh>
void check_is_triangulated(const View& view, const TriangleMesh& tmesh)
{
  for(const auto f : faces(tmesh))
    view.other_edges(view.halfedge(f));
}

/// returns the mean length of the edges; 0 without an edge of finite length.
template <typename View, typename TriangleMesh>
typename View::Scalar mean_edge_length(const View& view, const TriangleMesh& tmesh)
{
  using Scalar = typename View::Scalar;
  Scalar mean = 0;
  std::size_t count = 0;
  for(const auto e : edges(tmesh))
  {
    const auto h = halfedge(e, tmesh);
    const Vec3<Scalar> d = view.point(view.target(h)) - view.point(view.source(h));
    const Scalar length = std::hypot(d.x(), d.y(), d.z());
    if(std::isfinite(length))
      mean += (length - mean) / Scalar(++count); // a running mean doesn't overflow
  }
  return mean;
}

/// returns the site of a query: a vertex, or a `PMP::Face_location`.
template <typename View, typename Query>
Site<View> site_of(const View& view, const Query& query)
{
  using Scalar = typename View::Scalar;
  if constexpr(std::is_convertible<Query, typename View::Vertex>::value)
  {
    if(query == View::null_vertex())
      throw std::invalid_argument("Spider: query is the null vertex: give a vertex of tmesh");
    return site_at_vertex(view, static_cast<typename View::Vertex>(query));
  }
  else
  {
    if(query.first == View::null_face())
      throw std::invalid_argument("Spider: query is at the null face: give a face of tmesh");
    std::array<Scalar, 3> coordinates;
    for(int i = 0; i < 3; ++i)
      coordinates[i] = to_scalar<Scalar>(query.second[i]);
    return site_at_location(view, query.first, coordinates);
  }
}

/// interpolates an attribute of the vertices at a site.
template <typename View, typename Attribute>
auto interpolate(const Site<View>& site, Attribute&& at_vertex)
{
  auto sum = at_vertex(site.vertices[0]);
  sum *= site.weights[0];
  for(int i = 1; i < 3; ++i)
    if(site.weights[i] > 0)
      sum += site.weights[i] * at_vertex(site.vertices[i]);
  return sum;
}

template <typename TriangleMesh, typename NamedParameters>
class Mesh_inputs
{
public:
  using GT = typename CGAL::GetGeomTraits<TriangleMesh, NamedParameters>::type;
  using Result_traits = Result_kernel<GT>;
  using Vertex_point_map = typename CGAL::GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  template <typename Tag>
  using Given = std::decay_t<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(), Tag()))>;
  using Attributes =
    Growth_attributes<Given<CGAL::internal_np::edge_is_constrained_t>, Given<Spider::internal_np::growth_cost_map_t>>;
  using View = Graph_view<TriangleMesh, Vertex_point_map, Attributes>;
  using Scalar = typename View::Scalar;
  using Vertex = typename View::Vertex;

  static constexpr bool has_radius = is_given<Given<Spider::internal_np::geodesic_radius_t>>;
  static constexpr bool has_radii = is_given<Given<Spider::internal_np::geodesic_radii_t>>;
  static_assert(!(has_radius && has_radii), "Spider: give geodesic_radius or geodesic_radii, not both");
  static constexpr bool has_given_normals = is_given<Given<CGAL::internal_np::vertex_normal_map_t>>;
  static constexpr bool has_elongations = is_given<Given<Spider::internal_np::limb_elongation_map_t>>;

  /// `default_estimator` is the one whose defaults hold where no estimator is named.
  Mesh_inputs(const TriangleMesh& tmesh, const NamedParameters& np, Estimator default_estimator,
              Star_extent star_extent = patch_of_star)
    : options(read_options<Scalar>(np, default_estimator)),
      view(tmesh,
           parameters::choose_parameter(parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                        get_const_property_map(CGAL::vertex_point, tmesh)),
           Attributes(parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained),
                      parameters::get_parameter(np, Spider::internal_np::growth_cost_map), star_extent)),
      np_(np)
  {
    if(!(has_radius || has_radii) || options.number_of_directions == 0)
      options.mean_edge_length = mean_edge_length(view, tmesh);
    radius_ = read_radius();
  }

  /// returns the geodesic radius at a vertex; if there are several radii, that of first normals.
  Scalar radius_at(Vertex v) const
  {
    const auto given = parameters::get_parameter(np_, Spider::internal_np::geodesic_radius);
    if constexpr(has_radius_map())
      return to_scalar<Scalar>(get(given, v));
    else
      return radius_;
  }

  /// returns the unit normal at a vertex that the caller gave by `vertex_normal_map`.
  Vec3<Scalar> given_normal_at(Vertex v) const
  {
    return unit(to_vec3<Scalar>(get(parameters::get_parameter(np_, Spider::internal_np::vertex_normal_map), v)));
  }

  /// returns along which direction limbs at a vertex are longer than across it, given by `limb_elongation_map`.
  Vec3<Scalar> elongation_at(Vertex v) const
  {
    const auto given = parameters::get_parameter(np_, Spider::internal_np::limb_elongation_map);
    const Vec3<Scalar> elongation = to_vec3<Scalar>(get(given, v));
    const Scalar length = elongation.stableNorm();
    check_parameter(options.estimator == surface_fit || !(length > 1), "limb_elongation_map", length,
                    "leave it out with section_fit, whose limbs are all as long");
    return elongation;
  }

  static constexpr bool has_radius_map()
  {
    using Radius = Given<Spider::internal_np::geodesic_radius_t>;
    return is_given<Radius> && !is_number<Radius>;
  }

  Options<Scalar> options;
  View view;
  Radius_list<Scalar> radii; ///< those given by `geodesic_radii`

private:
  Scalar read_radius()
  {
    const auto given = parameters::get_parameter(np_, Spider::internal_np::geodesic_radius);
    if constexpr(has_radii)
    {
      // Neither so small that noise turns first normals, nor so large that they are those of somewhere else.
      radii = Radius_list<Scalar>(parameters::get_parameter(np_, Spider::internal_np::geodesic_radii));
      const Scalar least = radii.ascending.front(), greatest = radii.ascending.back();
      return least * (std::sqrt(greatest) / std::sqrt(least)); // whose parts don't overflow
    }
    else if constexpr(has_radius_map())
      return nan<Scalar>(); // each vertex has its own
    else if constexpr(is_given<decltype(given)>)
    {
      const Scalar radius = to_scalar<Scalar>(given);
      check_radius(radius);
      return radius;
    }
    else
    {
      constexpr Scalar default_radius_in_edges = 4;
      return default_radius_in_edges * options.mean_edge_length;
    }
  }

  NamedParameters np_;
  Scalar radius_;
};

/// returns the normal from which a site's spider starts. `normal_at` gives that of a vertex: the caller's own, or the
/// neighbourhood's.
template <typename View, typename NormalAt>
Vec3<typename View::Scalar> first_normal_of(const View& view, const Site<View>& site, typename View::Scalar radius,
                                            bool is_given_by_map, First_normal kind, NormalAt&& normal_at)
{
  using Normal = Vec3<typename View::Scalar>;
  if(site.rim.empty())
    return nan_vec3<typename View::Scalar>();
  if(!is_given_by_map && kind == incident_faces)
    return incident_faces_normal(view, site, radius);
  if(!is_given_by_map && kind == sphere_section)
  {
    const Normal normal = sphere_section_normal(view, site, radius);
    if(normal.allFinite())
      return normal; // else all of the component is inside the sphere
  }
  return unit<typename View::Scalar>(interpolate(site, normal_at));
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_MESH_INPUTS_H
