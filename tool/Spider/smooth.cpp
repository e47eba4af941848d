// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "smooth.h"

namespace CGAL {
namespace Spider {
namespace tool {

Smoothing_result<double> smooth(Mesh& mesh, const Smoothing_settings& settings, const Mesh_attributes& attributes)
{
  namespace params = Spider::parameters;

  const auto chain = params::ring_weight(settings.ring_weight)
                       .line_motion(settings.line_motion)
                       .keep_volume(settings.keeps_volume)
                       .limb_measure(settings.limb_measure)
                       .number_of_directions(settings.number_of_directions.value_or(16))
                       .smoothing_factor(settings.factor.value_or(0.2))
                       .convergence_displacement(settings.convergence_displacement.value_or(0));
  const auto run = [&](const auto& own) {
    return smooth_by_geodesic_rings<CGAL::Parallel_if_available_tag>(
      mesh, own.number_of_iterations(*settings.rounds)
              .edge_is_constrained_map(Array_map<Mesh::Edge_index, const char>{attributes.is_feature.data()})
              .vertex_is_constrained_map(Array_map<Vertex, const char>{attributes.is_constrained.data()}));
  };
  const auto run_with_costs = [&](const auto& own) {
    const Array_map<Mesh::Face_index, const double> costs{attributes.growth_costs.data()};
    return attributes.growth_costs.empty() ? run(own) : run(own.growth_cost_map(costs));
  };
  return settings.radius ? run_with_costs(chain.geodesic_radius(*settings.radius)) : run_with_costs(chain);
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
