// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_CURVATURE_ESTIMATOR_H
#define CGAL_SPIDER_CURVATURE_ESTIMATOR_H

#include <CGAL/Spider/Curvature_estimate_3.h>
#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Spider/internal/Mesh_inputs.h>
#include <CGAL/Spider/internal/Mesh_snapshot.h>
#include <CGAL/Spider/internal/Spider_engine.h>
#include <CGAL/Spider/internal/continuous_reference.h>
#include <CGAL/Spider/internal/neighbourhood_normals.h>
#include <CGAL/Spider/internal/spatial_order.h>

#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderClasses

The answers of `estimate_curvature()` and `estimate_normal()` for many queries to one mesh.

Construction reads the mesh and the parameters once, in time and memory linear in the size of the mesh, into a compact
copy; after that the mesh isn't looked at any more, and changes to it don't show. Queries may come from several threads
at once.

\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
*/
template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
class Curvature_estimator
{
  using Inputs = internal::Mesh_inputs<TriangleMesh, NamedParameters>;
  using Scalar = typename Inputs::Scalar;
  using Snapshot = internal::Mesh_snapshot<Scalar>;
  using Normal = internal::Vec3<Scalar>;
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;

public:
  /// the kernel of the answers: that of the mesh's points, or `Simple_cartesian<double>` where the number type of that
  /// kernel isn't floating-point
  using Result_traits = typename Inputs::Result_traits;
  using Estimate = Curvature_estimate_3<Result_traits>; ///< the type of an estimate
  /// the type of the answers: an estimate, or one for each of `geodesic_radii` where these are given
  using Answer = std::conditional_t<Inputs::has_radii, std::vector<Estimate>, Estimate>;
  using Vector_3 = typename Result_traits::Vector_3;    ///< the type of normals

  /// reads a mesh.
  /// \tparam ConcurrencyTag `CGAL::Sequential_tag` (the default), `CGAL::Parallel_tag` or
  ///         `CGAL::Parallel_if_available_tag`; the answers are the same to the last bit
  /// \param tmesh a triangle mesh
  /// \param np an optional sequence of named parameters, those of `estimate_curvature()`
  /// \param tag tells whether several threads may read
  /// \throw std::invalid_argument if a parameter is out of its range, or a face isn't a triangle
  template <typename ConcurrencyTag = CGAL::Sequential_tag>
  explicit Curvature_estimator(const TriangleMesh& tmesh,
                               const NamedParameters& np = CGAL::parameters::default_values(),
                               ConcurrencyTag tag = ConcurrencyTag())
    : Curvature_estimator(tag, tmesh, Inputs(tmesh, np, surface_fit))
  {
  }

  /// estimates as `estimate_curvature()` does.
  /// \tparam Query a model of `SpiderQuery`
  /// \param query a vertex, or a point of a face as a `CGAL::Polygon_mesh_processing::Face_location`
  /// \return the estimate, or estimates
  /// \throw std::invalid_argument if the query isn't of the mesh
  template <typename Query>
  Answer operator()(const Query& query) const
  {
    return worker()(query);
  }

  /// Answers as `Curvature_estimator` does, faster for many queries, since it keeps its buffers: for one thread.
  class Worker
  {
  public:
    /// estimates as `Curvature_estimator::operator()` does.
    /// \tparam Query a model of `SpiderQuery`
    /// \param query a vertex, or a point of a face
    /// \return the estimate, or estimates
    template <typename Query>
    Answer operator()(const Query& query)
    {
      internal::Site<Snapshot> site = estimator_.locate(query);
      const Scalar radius = estimator_.radius_at(site);
      const Normal normal = estimator_.first_normal(site);
      site.reference = internal::continuous_reference(estimator_.mesh_, site, normal,
                                                      estimator_.options_.number_of_directions_at(radius));
      if(!estimator_.elongations_.empty())
        site.shortening = internal::interpolate(
          site, [&](std::uint32_t v) { return internal::shortening_across(estimator_.elongations_[v]); });
      return internal::estimate_at<Inputs>(site, radius, estimator_.several_radii_, normal, engine_);
    }

  private:
    friend class Curvature_estimator;
    explicit Worker(const Curvature_estimator& estimator)
      : estimator_(estimator), engine_(estimator.mesh_, estimator.options_)
    {
    }

    const Curvature_estimator& estimator_;
    internal::Estimator_engine<Snapshot> engine_;
  };

  /// returns a worker that is valid as long as the estimator.
  Worker worker() const { return Worker(*this); }

  /// returns the vertices in an order in which neighbours follow soon after one another: the fastest for many queries.
  /// \tparam ConcurrencyTag as for the constructor
  template <typename ConcurrencyTag = CGAL::Sequential_tag>
  std::vector<Vertex> vertices_in_spatial_order() const
  {
    const std::vector<std::uint32_t> order = internal::spatial_order<ConcurrencyTag>(mesh_);
    std::vector<Vertex> result;
    result.reserve(order.size());
    for(std::uint32_t v : order)
      result.push_back(vertices_[v]);
    return result;
  }

  /// estimates a normal as `estimate_normal()` does.
  /// \tparam Query a model of `SpiderQuery`
  /// \param query a vertex, or a point of a face
  /// \return a unit vector, or NaN
  template <typename Query>
  Vector_3 normal(const Query& query) const
  {
    return internal::from_vec3<Vector_3>(first_normal(locate(query)));
  }

private:
  template <typename ConcurrencyTag>
  Curvature_estimator(ConcurrencyTag tag, const TriangleMesh& tmesh, const Inputs& inputs)
    : options_(inputs.options), vertices_(vertices(tmesh)), faces_(faces(tmesh)),
      mesh_(tmesh, inputs.view, vertices_, faces_, tag), several_radii_(inputs.radii)
  {
    if constexpr(Inputs::has_radius_map())
      for(std::size_t v = 0; v < vertices_.size(); ++v)
        radii_.push_back(inputs.radius_at(vertices_[v]));
    else if(vertices_.size() > 0)
      radii_.push_back(inputs.radius_at(vertices_[0]));

    if constexpr(Inputs::has_elongations)
      for(std::size_t v = 0; v < vertices_.size(); ++v)
        elongations_.push_back(inputs.elongation_at(vertices_[v]));

    if constexpr(Inputs::has_given_normals)
      for(std::size_t v = 0; v < vertices_.size(); ++v)
        normals_.push_back(inputs.given_normal_at(vertices_[v]));
    else if(options_.first_normal == neighbourhood)
    {
      internal::Normal_averaging<Scalar> averaging(tag, mesh_, [&](std::uint32_t v) { return radius_at_vertex(v); });
      mesh_.move_to({}); // averaging can do without the points, and takes as much memory
      normals_ = std::move(averaging).normals(tag, mesh_);
      mesh_.move_to(Snapshot::points_of(inputs.view, vertices_));
    }
  }

  template <typename Query>
  internal::Site<Snapshot> locate(const Query& query) const
  {
    if constexpr(std::is_convertible<Query, Vertex>::value)
    {
      const std::size_t v = vertices_(query);
      internal::check_parameter(v < vertices_.size(), "the rank of query", v, "give a vertex of tmesh");
      return internal::site_at_vertex(mesh_, static_cast<std::uint32_t>(v));
    }
    else
    {
      const std::size_t f = faces_(query.first);
      internal::check_parameter(f < faces_.size(), "the rank of query's face", f, "give a face of tmesh");
      return internal::site_of(mesh_, std::make_pair(static_cast<std::uint32_t>(f), query.second));
    }
  }

  Scalar radius_at_vertex(std::uint32_t v) const { return radii_.size() == 1 ? radii_[0] : radii_[v]; }

  Scalar radius_at(const internal::Site<Snapshot>& site) const
  {
    return internal::interpolate(site, [&](std::uint32_t v) { return radius_at_vertex(v); });
  }

  Normal first_normal(const internal::Site<Snapshot>& site) const
  {
    return internal::first_normal_of(mesh_, site, radius_at(site), Inputs::has_given_normals, options_.first_normal,
                                     [&](std::uint32_t v) -> Normal {
                                       return normals_.empty()
                                                ? internal::neighbourhood_normal_at_vertex(mesh_, v, radius_at_vertex(v))
                                                : normals_[v];
                                     });
  }

  internal::Options<Scalar> options_;
  internal::Ranks<Vertex> vertices_;
  internal::Ranks<Face> faces_;
  Snapshot mesh_;
  internal::Radius_list<Scalar> several_radii_;
  std::vector<Scalar> radii_;   ///< one for all, or one per vertex
  std::vector<Normal> elongations_; ///< of limbs, per vertex; or none
  std::vector<Normal> normals_; ///< per vertex; none if they are found where they are needed
};

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_CURVATURE_ESTIMATOR_H
