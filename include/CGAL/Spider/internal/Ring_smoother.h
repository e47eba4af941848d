// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_RING_SMOOTHER_H
#define CGAL_SPIDER_INTERNAL_RING_SMOOTHER_H

#include <CGAL/Spider/internal/Free_vertices.h>
#include <CGAL/Spider/internal/Mesh_lines.h>
#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Ring_centroid.h>
#include <CGAL/Spider/internal/Ring_radii.h>
#include <CGAL/Spider/internal/Vertex_motion.h>
#include <CGAL/Spider/internal/for_each_query.h>
#include <CGAL/Spider/internal/neighbourhood_normals.h>

#include <boost/range/counting_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

template <typename Scalar>
struct Smoothing_options
{
  int number_of_directions, number_of_iterations;
  Limb_measure limb_measure;
  Scalar factor = Scalar(0.2); // (paper, figure 11)
  Scalar convergence_displacement = 0;
  Ring_weight ring_weight = by_limb;
  Line_motion line_motion = fixed_lines;
  bool keep_volume = true;
  bool adapts_radii; // without giving back what is common, wide rings would shrink the mesh

  template <typename NamedParameters>
  Smoothing_options(const NamedParameters& np, const Options<Scalar>& options)
    : number_of_directions(options.number_of_directions), number_of_iterations(options.number_of_iterations),
      limb_measure(options.limb_rule.measure)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    namespace tags = Spider::internal_np;
    constexpr int enough_directions = 16; // a ring of half an edge meets some six faces
    if(!is_given<decltype(get_parameter(np, tags::number_of_directions))>)
      number_of_directions = enough_directions;
    factor = static_cast<Scalar>(choose_parameter(get_parameter(np, tags::smoothing_factor), factor));
    check_parameter(factor > 0 && factor <= 1, "smoothing_factor", factor, "give a share greater than 0 and at most 1");
    convergence_displacement = static_cast<Scalar>(
      choose_parameter(get_parameter(np, tags::convergence_displacement), convergence_displacement));
    check_parameter(convergence_displacement >= 0, "convergence_displacement", convergence_displacement,
                    "give a length that is not negative");
    ring_weight = choose_parameter(get_parameter(np, tags::ring_weight), ring_weight);
    line_motion = choose_parameter(get_parameter(np, tags::line_motion), line_motion);
    keep_volume = choose_parameter(get_parameter(np, tags::keep_volume), keep_volume);
    adapts_radii = keep_volume && !is_given<decltype(get_parameter(np, tags::geodesic_radius))>;
  }
};

/// Moves the vertices of a mesh round by round (paper, 3.1).
template <typename Scalar>
class Ring_smoother
{
  using View = Mesh_snapshot<Scalar>;
  using Vector = Vec3<Scalar>;
  using Vertex = typename View::Vertex;

public:
  struct Done
  {
    int number_of_iterations = 0;
    Scalar greatest_displacement = 0, mean_displacement = 0;
    Scalar volume_before = nan<Scalar>(), volume_after = nan<Scalar>();
  };

  Ring_smoother(View& mesh, const Smoothing_options<Scalar>& options, std::vector<Scalar> radii,
                const std::vector<bool>& is_fixed, bool is_closed)
    : mesh_(mesh), options_(options), radii_(std::move(radii)), is_fixed_(is_fixed), is_closed_(is_closed),
      lines_(mesh), free_(mesh, lines_, is_fixed)
  {}

  template <typename ConcurrencyTag>
  Done run()
  {
    Done done;
    const std::vector<Vector> first = mesh_.points();
    if(is_closed_ && !first.empty())
      done.volume_before = enclosed_volume(mesh_, first);
    Scalar displacement = std::numeric_limits<Scalar>::infinity();
    while(done.number_of_iterations < options_.number_of_iterations && displacement > options_.convergence_displacement)
    {
      const std::vector<Vector> before = mesh_.points();
      std::vector<Vector> ways = ways_to_centroids<ConcurrencyTag>();
      if(options_.keep_volume)
      {
        give_back_what_is_common<ConcurrencyTag>(ways);
        stay_near<ConcurrencyTag>(first, ways);
      }
      mesh_.move_to(moved_as_far_as_sound(mesh_, ways));
      if(options_.keep_volume && is_closed_)
        step_to_volume(done.volume_before);
      displacement = 0;
      for(std::size_t v = 0; v < before.size(); ++v)
        displacement = std::max(displacement, (mesh_.points()[v] - before[v]).norm());
      ++done.number_of_iterations;
    }

    for(std::size_t v = 0; v < first.size(); ++v)
    {
      const Scalar distance = (mesh_.points()[v] - first[v]).norm();
      if(!std::isfinite(distance))
        continue;
      done.greatest_displacement = std::max(done.greatest_displacement, distance);
      done.mean_displacement += distance / Scalar(first.size());
    }
    if(is_closed_ && !first.empty())
      done.volume_after = enclosed_volume(mesh_, mesh_.points());
    return done;
  }

private:
  template <typename ConcurrencyTag>
  std::vector<Vector> ways_to_centroids() const
  {
    const std::vector<Vector> normals = neighbourhood_normals(mesh_, [&](Vertex v) { return radii_[v]; });
    std::vector<Vector> ways(mesh_.number_of_vertices(), Vector::Zero());
    for_each_query<ConcurrencyTag>(
      boost::counting_range(Vertex(0), static_cast<Vertex>(ways.size())),
      [&] {
        return [&, centroid = Ring_centroid<Scalar>(mesh_, options_.number_of_directions, options_.limb_measure,
                                                    options_.ring_weight)](Vertex v) mutable -> Vector {
          if(free_.contains(v))
            return options_.factor * centroid(site_at_vertex(mesh_, v), radii_[v], radii_.narrowest(v), normals[v]);
          if(is_fixed_[v] || options_.line_motion == fixed_lines)
            return Vector::Zero();
          return options_.factor * lines_.way_along_line(v);
        };
      },
      [&](Vertex v, const Vector& way) { ways[v] = way; });
    return ways;
  }

  /// takes from the ways of free vertices what the vertices around have in common with them: where a whole
  /// neighbourhood goes one way it is for the shape of the surface, which shrinks by it, and not for noise. Two means
  /// on end make what is given back of any pattern of ways a share from 0 to 1 of it. One would turn the sign of those
  /// that alternate from vertex to vertex, which would then go up to half as far again.
  template <typename ConcurrencyTag>
  void give_back_what_is_common(std::vector<Vector>& ways)
  {
    const std::vector<Vector> common =
      free_.template means_around<ConcurrencyTag>(free_.template means_around<ConcurrencyTag>(ways));
    for(std::size_t v = 0; v < ways.size(); ++v)
      ways[v] -= common[v];
    if(options_.adapts_radii)
      radii_.template adapt<ConcurrencyTag>(free_, common, ways);
  }

  /// shortens ways that would lead farther from the first places than vertices nearby have gone: noise is about alike
  /// in a neighbourhood, and what asks for more of a vertex is a tip, whose ring lies beneath it in every round.
  template <typename ConcurrencyTag>
  void stay_near(const std::vector<Vector>& first, std::vector<Vector>& ways) const
  {
    constexpr Scalar farthest =
      Scalar(1.5); // root mean squares; noise that is uniform goes to 1.7, and half of it goes
    std::vector<Vector> displacements(ways.size());
    for(std::size_t v = 0; v < ways.size(); ++v)
      displacements[v] = mesh_.points()[v] + ways[v] - first[v];
    const std::vector<Scalar> squares = free_.template mean_squares_near<ConcurrencyTag>(displacements);
    for(Vertex v = 0; v < static_cast<Vertex>(ways.size()); ++v)
    {
      const Scalar share = farthest * std::sqrt(squares[v]) / displacements[v].norm();
      if(free_.contains(v) && share < 1)
        ways[v] = first[v] + share * displacements[v] - mesh_.points()[v];
    }
  }

  /// has free vertices step along their normals, all by one length, so that the mesh encloses a volume.
  void step_to_volume(Scalar volume)
  {
    constexpr int most_steps = 8; // of Newton's method, which needs two or three
    constexpr Scalar as_good = Scalar(1e-6);
    for(int step = 0; step < most_steps; ++step)
    {
      const Scalar missing = volume - enclosed_volume(mesh_, mesh_.points());
      if(!(std::abs(missing) > as_good * std::abs(volume)))
        return;
      std::vector<Vector> ways(mesh_.number_of_vertices(), Vector::Zero());
      Scalar area = 0; // of the faces around free vertices, a third for each
      for(Vertex v = 0; v < static_cast<Vertex>(ways.size()); ++v)
        if(free_.contains(v))
        {
          const Vector area_of_star = area_vector(mesh_, site_at_vertex(mesh_, v), Scalar(1)) / 3;
          area += area_of_star.norm();
          ways[v] = unit(area_of_star);
        }
      for(Vector& way : ways)
        way = way.allFinite() && area > 0 ? Vector(missing / area * way) : Vector(Vector::Zero());
      mesh_.move_to(moved_as_far_as_sound(mesh_, ways));
    }
  }

  View& mesh_;
  const Smoothing_options<Scalar>& options_;
  Ring_radii<Scalar> radii_;
  const std::vector<bool>& is_fixed_;
  bool is_closed_;
  Mesh_lines<Scalar> lines_;
  Free_vertices<Scalar> free_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_RING_SMOOTHER_H
