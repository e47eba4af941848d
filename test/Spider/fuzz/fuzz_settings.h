// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Named parameters of every kind and value, some of them wrong.

#ifndef CGAL_SPIDER_FUZZ_SETTINGS_H
#define CGAL_SPIDER_FUZZ_SETTINGS_H

#include "fuzz_meshes.h"

#include <CGAL/Spider/parameters.h>

#include <cmath>
#include <limits>
#include <vector>

namespace fuzz {

namespace Spider = CGAL::Spider;

/// The values of all named parameters, and the attributes of the mesh that go with them.
struct Settings
{
  double mean_edge_length, radius;
  int number_of_directions, polynomial_degree, number_of_iterations;
  Spider::Estimator estimator;
  Spider::Limb_measure limb_measure;
  Spider::First_normal first_normal;
  Spider::Ring_weight ring_weight;
  Spider::Line_motion line_motion;
  double resampling_step, convergence_angle, minimum_crossing_angle, smoothing_factor;
  bool keep_volume;
  bool are_valid = true; ///< else a function that reads what is wrong refuses it
  bool radii_have_slips = false;
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;
  Mesh::Property_map<Mesh::Vertex_index, bool> is_constrained;
  Mesh::Property_map<Mesh::Face_index, double> cost;
  Mesh::Property_map<Mesh::Vertex_index, double> radii;
  Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3> normals;

  /// returns every parameter of estimation.
  auto all() const
  {
    return Spider::parameters::geodesic_radius(radius)
      .number_of_directions(number_of_directions)
      .estimator(estimator)
      .limb_measure(limb_measure)
      .polynomial_degree(polynomial_degree)
      .resampling_step(resampling_step)
      .convergence_angle(convergence_angle)
      .first_normal(first_normal)
      .minimum_crossing_angle(minimum_crossing_angle)
      .growth_cost_map(cost)
      .edge_is_constrained_map(is_feature)
      .number_of_iterations(number_of_iterations);
  }

  /// returns the radius alone; the rest is left to defaults.
  auto few() const { return Spider::parameters::geodesic_radius(radius); }

  /// returns maps of radii and normals, in which anything may be.
  auto by_maps() const
  {
    return Spider::parameters::geodesic_radius(radii).estimator(estimator).vertex_normal_map(normals);
  }

  auto of_smoothing() const
  {
    return Spider::parameters::geodesic_radius(radii)
      .smoothing_factor(smoothing_factor)
      .ring_weight(ring_weight)
      .line_motion(line_motion)
      .keep_volume(keep_volume)
      .limb_measure(limb_measure)
      .growth_cost_map(cost)
      .number_of_iterations(2)
      .edge_is_constrained_map(is_feature)
      .vertex_is_constrained_map(is_constrained);
  }
};

/// returns the mean length of the edges of finite length; 0 without one.
inline double mean_edge_length(const Mesh& mesh)
{
  double mean = 0;
  std::size_t count = 0;
  for(Mesh::Edge_index e : mesh.edges())
  {
    const auto d = mesh.point(mesh.vertex(e, 0)) - mesh.point(mesh.vertex(e, 1));
    const double length = std::hypot(d.x(), d.y(), d.z());
    if(std::isfinite(length))
      mean += (length - mean) / double(++count);
  }
  return mean;
}

inline Kernel::Vector_3 random_vector(Random& random)
{
  return {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
}

/// returns what a caller's map may hold by mistake.
inline double random_slip(Random& random)
{
  const std::vector<double> slips = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                     0., -1.};
  return random.one_of(slips);
}

inline void add_attributes(Settings& settings, Mesh& mesh, Random& random)
{
  settings.is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  settings.is_constrained = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_constrained", false).first;
  settings.cost = mesh.add_property_map<Mesh::Face_index, double>("f:cost", 1).first;
  settings.radii = mesh.add_property_map<Mesh::Vertex_index, double>("v:radius", settings.radius).first;
  settings.normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  const std::size_t one_edge_of = 1 + random.below(20), one_face_of = 1 + random.below(20);
  if(!random.one_in(3))
    for(Mesh::Edge_index e : mesh.edges())
      settings.is_feature[e] = random.one_in(one_edge_of);
  if(!random.one_in(3))
    for(Mesh::Face_index f : mesh.faces())
      if(random.one_in(one_face_of))
        settings.cost[f] = random.one_in(2) ? std::numeric_limits<double>::infinity() : random.power_of_ten(0, 3);
  settings.radii_have_slips = random.one_in(4);
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    settings.is_constrained[v] = random.one_in(10);
    settings.radii[v] = settings.radii_have_slips && random.one_in(8) ? random_slip(random)
                                                                      : settings.radius * random.power_of_ten(-1, 1);
    settings.radii_have_slips |= !(settings.radii[v] > 0) || !std::isfinite(settings.radii[v]); // tiny ones vanish
    settings.normals[v] = random.one_in(20) ? Kernel::Vector_3(random_slip(random), 0, 0) : random_vector(random);
  }
}

/// makes one of the parameters of estimation wrong.
inline void spoil(Settings& settings, Random& random)
{
  settings.are_valid = false;
  const double bad_number = random_slip(random);
  switch(random.below(6))
  {
    case 0: settings.radius = bad_number; break;
    case 1: settings.number_of_directions = random.between(-3, 1); break;
    case 2: settings.polynomial_degree = random.between(-1, 1); break;
    case 3: settings.number_of_iterations = random.between(-2, 0); break;
    case 4: settings.resampling_step = bad_number; break;
    default: settings.minimum_crossing_angle = random.one_in(2) ? -1 : 91; break;
  }
}

/// returns settings of which one in twenty has a parameter that is wrong; adds attributes to the mesh.
inline Settings random_settings(Mesh& mesh, Random& random)
{
  Settings settings;
  settings.mean_edge_length = mean_edge_length(mesh);
  const double unit = settings.mean_edge_length > 0 ? settings.mean_edge_length : 1;
  settings.radius = unit * (random.one_in(3) ? random.power_of_ten(-6, 3) : random.power_of_ten(-0.5, 1));
  if(!(settings.radius > 0) || !std::isfinite(settings.radius))
    settings.radius = unit;
  settings.number_of_directions = 2 * random.between(2, random.one_in(16) ? 40 : 6);
  settings.polynomial_degree = random.between(2, 4);
  settings.number_of_iterations = random.between(1, 10);
  settings.estimator = random.one_in(3) ? Spider::section_fit : Spider::surface_fit;
  settings.limb_measure = random.one_in(2) ? Spider::arc_length : Spider::tangential_distance;
  settings.first_normal = static_cast<Spider::First_normal>(random.below(3));
  settings.ring_weight = random.one_in(2) ? Spider::by_limb : Spider::by_arc;
  settings.line_motion = random.one_in(2) ? Spider::fixed_lines : Spider::sliding_lines;
  settings.resampling_step = random.power_of_ten(-2, 0);
  settings.convergence_angle = random.one_in(3) ? 0 : random.power_of_ten(-4, 1);
  settings.minimum_crossing_angle = random.real(0, 90);
  settings.smoothing_factor = random.real(0.001, 1);
  settings.keep_volume = random.one_in(2);
  add_attributes(settings, mesh, random);
  if(random.one_in(20))
    spoil(settings, random);
  return settings;
}

} // namespace fuzz

#endif // CGAL_SPIDER_FUZZ_SETTINGS_H
