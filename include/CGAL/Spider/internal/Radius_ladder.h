// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_RADIUS_LADDER_H
#define CGAL_SPIDER_INTERNAL_RADIUS_LADDER_H

#include <CGAL/Spider/internal/Error_balance.h>
#include <CGAL/Spider/internal/Mesh_inputs.h>
#include <CGAL/Spider/internal/Mesh_snapshot.h>
#include <CGAL/Spider/internal/Spider_engine.h>
#include <CGAL/Spider/internal/for_each_query.h>
#include <CGAL/Spider/internal/neighbourhood_normals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// returns some of a range's elements, or all if there aren't more: always the same ones, but at random, since a mesh
/// may be numbered row by row.
template <typename T>
std::vector<T> subsample(std::vector<T> elements, std::size_t count)
{
  std::mt19937 random; // its numbers are the same everywhere, those of the distributions aren't
  count = std::min(count, elements.size());
  for(std::size_t i = 0; i < count; ++i)
    std::swap(elements[i], elements[i + random() % (elements.size() - i)]);
  elements.resize(count);
  return elements;
}

/// Estimates at vertices of a mesh with one radius after the other, each from the normal that the one before ended
/// with.
template <typename TriangleMesh, typename NamedParameters>
class Radius_ladder
{
  using Inputs = Mesh_inputs<TriangleMesh, NamedParameters>;

public:
  using Scalar = typename Inputs::Scalar;
  using Snapshot = Mesh_snapshot<Scalar>;
  using Result_traits = typename Inputs::Result_traits;
  using Samples = typename Error_balance<Scalar>::Samples;

  /// 256 vertices are many enough for the mean of what noise does to be known within 10 %. Twice as many set out, since
  /// borders may stop half of them.
  static constexpr std::size_t sample_size = 512;

  Radius_ladder(const TriangleMesh& tmesh, const NamedParameters& np)
    : inputs_(tmesh, np, surface_fit), vertices_(vertices(tmesh)),
      mesh_(tmesh, inputs_.view, vertices_, Ranks<Face>(faces(tmesh)))
  {
    if(!(inputs_.options.mean_edge_length > 0)) // it wasn't needed so far
      inputs_.options.mean_edge_length = internal::mean_edge_length(inputs_.view, tmesh);
  }

  const Snapshot& mesh() const { return mesh_; }
  auto vertex(std::uint32_t rank) const { return vertices_[rank]; }
  Scalar mean_edge_length() const { return inputs_.options.mean_edge_length; }

  /// returns the ranks of all vertices that have a face.
  std::vector<std::uint32_t> vertices_of_faces() const
  {
    std::vector<std::uint32_t> ranks;
    for(std::uint32_t v = 0; v < mesh_.number_of_vertices(); ++v)
      if(mesh_.first_corner(v) != Snapshot::null_halfedge())
        ranks.push_back(v);
    return ranks;
  }

  /// returns the radius of least error in edge lengths, judged by a sample of some vertices; `edge_length_at` gives the
  /// edge length that a vertex' radii are multiples of.
  template <typename ConcurrencyTag, typename EdgeLength>
  std::optional<Scalar> best_radius(std::vector<std::uint32_t> candidates, const EdgeLength& edge_length_at) const
  {
    std::vector<Climber> climbers;
    for(std::uint32_t v : subsample(std::move(candidates), sample_size))
      climbers.push_back({v, edge_length_at(v), nan_vec3<Scalar>(), {}});

    const auto make_worker = [&] {
      return [this, engine = Estimator_engine<Snapshot>(mesh_, inputs_.options)](const Climber& climber) mutable {
        return step(engine, climber);
      };
    };
    // Large radii cost most: they are for half of the sample, and where blurring has set in they needn't be tried.
    constexpr int cheap_rungs = 3;
    std::optional<Error_balance<Scalar>> balance;
    for(int k = 0; k < number_of_rungs && !(balance && balance->is_settled()); ++k)
    {
      std::vector<Climber> next;
      std::size_t room = k + 1 < cheap_rungs ? sample_size : sample_size / 2;
      for_each_query<ConcurrencyTag>(climbers, make_worker, [&](const auto&, const Climber& climber) {
        if(climber.is_climbing && room == 0)
          return;
        next.push_back(climber);
        room -= climber.is_climbing;
      });
      climbers = std::move(next);
      balance.emplace(values_of(climbers));
    }
    return balance->best_radius();
  }

  /// calls `store(v, estimates)` for some vertices, with the estimates at the radii of the first rungs, from one walk
  /// each.
  template <typename ConcurrencyTag, typename Store>
  void climb(const std::vector<std::uint32_t>& ranks, int rungs, const std::vector<Scalar>& edge_lengths,
             const Store& store) const
  {
    // With as few directions, means over many vertices are as good.
    constexpr int few_directions = 12;
    Options<Scalar> options = inputs_.options;
    if(options.number_of_directions == 0)
      options.number_of_directions = few_directions;
    std::vector<Vec3<Scalar>> normals; // of all vertices at once, where so many are needed
    if constexpr(!Inputs::has_given_normals)
      if(options.first_normal == neighbourhood)
        normals = neighbourhood_normals<ConcurrencyTag>(
          mesh_, [&](std::uint32_t v) { return rung(Scalar(1)) * edge_lengths[v]; });
    const auto make_worker = [&] {
      return [this, rungs, &edge_lengths, &normals, engine = Estimator_engine<Snapshot>(mesh_, options),
              radii = std::vector<Scalar>(), estimates = std::vector<Estimate<Scalar>>()](std::uint32_t v) mutable {
        radii.clear();
        for(int k = 0; k < rungs; ++k)
          radii.push_back(rung(Scalar(k)) * edge_lengths[v]);
        const Site<Snapshot> site = site_at_vertex(mesh_, v);
        engine(site, radii, normals.empty() ? first_normal(site, radii[1]) : normals[v], estimates);
        return estimates;
      };
    };
    for_each_query<ConcurrencyTag>(ranks, make_worker, store);
  }

private:
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  /// A vertex with its estimates so far.
  struct Climber
  {
    std::uint32_t vertex;
    Scalar edge_length;
    Vec3<Scalar> normal;
    Rung_values<Scalar> values;
    bool is_climbing = true; ///< up to the largest radius at which there is an estimate that no border spoils
  };

  Climber step(Estimator_engine<Snapshot>& engine, Climber climber) const
  {
    if(!climber.is_climbing)
      return climber;
    const Site<Snapshot> site = site_at_vertex(mesh_, climber.vertex);
    const int k = climber.values.usable;
    const Scalar radius = rung(Scalar(k)) * climber.edge_length;
    const Estimate<Scalar> estimate = engine(site, radius, k == 0 ? first_normal(site, radius) : climber.normal);
    const Scalar H = (estimate.min_curvature + estimate.max_curvature) / 2 * climber.edge_length;
    climber.is_climbing = !estimate.meets_border && std::isfinite(H);
    if(climber.is_climbing)
    {
      climber.values.mean_curvatures[k] = H;
      climber.values.standard_errors[k] = estimate.standard_error * climber.edge_length;
      climber.values.usable = k + 1;
      climber.normal = estimate.normal;
    }
    return climber;
  }

  static Samples values_of(const std::vector<Climber>& climbers)
  {
    Samples samples;
    for(const Climber& climber : climbers)
      samples.push_back(climber.values);
    return samples;
  }

  Vec3<Scalar> first_normal(const Site<Snapshot>& site, Scalar radius) const
  {
    return first_normal_of(mesh_, site, radius, Inputs::has_given_normals, inputs_.options.first_normal,
                           [&](std::uint32_t v) -> Vec3<Scalar> {
                             if constexpr(Inputs::has_given_normals)
                               return inputs_.given_normal_at(vertices_[v]);
                             else
                               return neighbourhood_normal_at_vertex(mesh_, v, radius);
                           });
  }

  Inputs inputs_;
  Ranks<Vertex> vertices_;
  Snapshot mesh_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_RADIUS_LADDER_H
