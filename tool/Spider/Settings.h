// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_SETTINGS_H
#define CGAL_SPIDER_TOOL_SETTINGS_H

#include <CGAL/Spider/parameters.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// The named parameters of estimation that are plain values, or in the mesh file; what isn't given is left to the
// library's defaults.
struct Estimation_settings
{
  bool as_published = false;
  bool uses_vertex_normals = false; // those of the mesh file
  std::optional<Estimator> estimator;
  std::optional<Limb_measure> limb_measure;
  std::optional<First_normal> first_normal;
  // wide and signed, so that the library sees, and refuses, what was typed
  std::optional<long long> number_of_directions, polynomial_degree, number_of_iterations;
  std::optional<double> resampling_step, convergence_angle, minimum_crossing_angle;
};

// How far limbs grow: lengths, multiples of the mean edge length, a length for each vertex, or what the library
// suggests.
struct Radius_settings
{
  std::vector<double> lengths, in_edges;
  std::string by_vertex; // a file
  bool is_suggested = false;
  bool is_suggested_by_vertex = false;
  bool is_adaptive = false;
  bool adapts_by_direction = false;
};

struct Smoothing_settings
{
  std::optional<long long> rounds; // none: no smoothing
  std::optional<double> radius, factor, convergence_displacement;
  std::optional<long long> number_of_directions;
  Limb_measure limb_measure = arc_length;
  std::string constrained_vertices; // a file
  Ring_weight ring_weight = by_limb;
  Line_motion line_motion = fixed_lines;
  bool keeps_volume = true;
};

// A line along which a field has a value.
struct Isoline_request
{
  std::string field;
  double value;
};

struct Ridge_settings
{
  std::string file; // none: no ridges
  std::optional<double> minimum_strength, minimum_sharpness;
};

struct Limb_settings
{
  std::vector<std::size_t> vertices; // none: no limbs
  std::string file = "limbs.vtp";
};

struct Picture_settings
{
  std::string file;
  std::vector<double> view = {0.3, 0.3, 1}; // from the mesh to the viewer
  std::vector<double> up = {0, 1, 0};
};

// All that the command line says.
struct Settings
{
  std::string mesh;
  Radius_settings radius;
  Estimation_settings estimation;
  std::optional<double> feature_angle;
  std::string constrained_edges, growth_costs; // files
  Smoothing_settings smoothing;

  std::string output, mesh_output, isolines_output = "isolines.vtp";
  std::string colour_by = "H";
  bool labels = false;
  std::optional<double> flatness_threshold;
  std::vector<Isoline_request> isolines;
  Ridge_settings ridges;
  Limb_settings limbs;
  Picture_settings picture;

  bool compares_with_jets = false;
  bool is_quiet = false;
  bool is_json = false;
};

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_SETTINGS_H
