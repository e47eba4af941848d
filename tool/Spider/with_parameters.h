// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_WITH_PARAMETERS_H
#define CGAL_SPIDER_TOOL_WITH_PARAMETERS_H

#include "estimate.h"

#include <CGAL/Spider/parameters.h>

namespace CGAL {
namespace Spider {
namespace tool {

inline auto radius_parameters(const std::vector<double>& of_vertex)
{
  return parameters::geodesic_radius(Array_map<Vertex, const double>{of_vertex.data()});
}

// `elongations` may be written.
inline auto limb_parameters(const std::vector<double>& radius_of_vertex, std::vector<Kernel::Vector_3>& elongations)
{
  return radius_parameters(radius_of_vertex)
    .limb_elongation_map(Array_map<Vertex, Kernel::Vector_3>{elongations.data()});
}

// returns what `action` does of some named parameters and of those that the settings stand for. What a chain holds is
// fixed when the program is compiled, so the documented defaults are spelled out, apart from the number of directions,
// which depends on the radius.
template <typename NamedParameters, typename Action>
auto with_parameters(const NamedParameters& np, const Estimation_settings& settings, const Mesh_attributes& attributes,
                     const Action& action)
{
  const bool published = settings.as_published;
  const Estimator estimator = settings.estimator.value_or(published ? section_fit : surface_fit);
  const bool by_sections = estimator == section_fit;
  const auto chain =
    np.estimator(estimator)
      .limb_measure(settings.limb_measure.value_or(published || by_sections ? arc_length : tangential_distance))
      .polynomial_degree(settings.polynomial_degree.value_or(2))
      .resampling_step(settings.resampling_step.value_or(0.1))
      .convergence_angle(settings.convergence_angle.value_or(by_sections ? 1e-3 : 0.3))
      .first_normal(settings.first_normal.value_or(published ? sphere_section : neighbourhood))
      .minimum_crossing_angle(settings.minimum_crossing_angle.value_or(30));

  const auto with_cgals = [&](const auto& own) {
    const auto all = own.number_of_iterations(settings.number_of_iterations.value_or(10))
                       .edge_is_constrained_map(Array_map<Mesh::Edge_index, const char>{attributes.is_feature.data()});
    const Array_map<Vertex, const Kernel::Vector_3> normals{attributes.vertex_normals.data()};
    return attributes.vertex_normals.empty() ? action(all) : action(all.vertex_normal_map(normals));
  };
  const auto with_costs = [&](const auto& own) {
    const Array_map<Mesh::Face_index, const double> costs{attributes.growth_costs.data()};
    return attributes.growth_costs.empty() ? with_cgals(own) : with_cgals(own.growth_cost_map(costs));
  };
  const auto published_directions = published ? std::optional<long long>(64) : std::nullopt;
  const auto directions = settings.number_of_directions ? settings.number_of_directions : published_directions;
  return directions ? with_costs(chain.number_of_directions(*directions)) : with_costs(chain);
}

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_WITH_PARAMETERS_H
