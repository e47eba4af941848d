// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "smooth.h"

namespace CGAL {
namespace Spider {
namespace tool {

Smoothing_result<double> smooth(Mesh& mesh, const Smoothing_settings& settings, const Growth_limits& limits)
{
  namespace params = Spider::parameters;

  const auto chain = params::ring_weight(settings.ring_weight)
                       .line_motion(settings.line_motion)
                       .keep_volume(settings.keeps_volume)
                       .smoothing_factor(settings.factor.value_or(0.2))
                       .convergence_displacement(settings.convergence_displacement.value_or(0));
  const auto run = [&](const auto& own) {
    return smooth_by_geodesic_rings<CGAL::Parallel_if_available_tag>(
      mesh, own.number_of_iterations(*settings.rounds)
              .edge_is_constrained_map(Array_map<Mesh::Edge_index, const char>{limits.is_feature.data()}));
  };
  const auto run_with_costs = [&](const auto& own) {
    return limits.costs.empty()
             ? run(own)
             : run(own.growth_cost_map(Array_map<Mesh::Face_index, const double>{limits.costs.data()}));
  };
  return settings.radius ? run_with_costs(chain.geodesic_radius(*settings.radius)) : run_with_costs(chain);
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
