// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimate.h"

#include "for_each_vertex.h"
#include "read_numbers.h"
#include "with_parameters.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Spider/Curvature_estimator.h>
#include <CGAL/Spider/suggest_adaptive_radii.h>
#include <CGAL/Spider/suggest_geodesic_radius.h>

#include <boost/algorithm/string/predicate.hpp>

#include <cmath>
#include <set>
#include <sstream>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

std::string short_number(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

Radius constant_radius(const std::string& name, const Mesh& mesh, double length)
{
  return {name, std::vector<double>(mesh.num_vertices(), length), {}};
}

// The column radius of a CSV file, as --output writes one, or the numbers of a text file.
Radius radius_of_file(const std::string& file, const Mesh& mesh)
{
  Radius radius{
    "by_vertex", boost::algorithm::iends_with(file, ".csv") ? read_column(file, "radius") : read_numbers(file), {}};
  check_count(file, radius.of_vertex, mesh.num_vertices(), "vertices");
  for(double length : radius.of_vertex)
    if(length <= 0 || std::isinf(length)) // NaN is what a suggestion leaves where there are no edges
      throw std::invalid_argument(file + ": " + short_number(length) + " is no positive length");
  return radius;
}

// Files tell columns apart by them.
void check_names(const std::vector<Radius>& radii)
{
  std::set<std::string> names;
  for(const Radius& radius : radii)
    if(!names.insert(radius.name).second)
      throw std::invalid_argument("the radius " + radius.name + " is given twice: give each once");
}

Radius suggested_radius(const Mesh& mesh, const Settings& settings, const Mesh_attributes& attributes)
{
  const std::vector<double> unused(mesh.num_vertices(), 1);
  if(settings.radius.is_suggested)
    return constant_radius("suggested", mesh,
                           with_parameters(radius_parameters(unused), settings.estimation, attributes,
                                           [&](const auto& np) { return suggest_geodesic_radius(mesh, np); }));
  Radius radius{"suggested", std::vector<double>(mesh.num_vertices()), {}};
  const Array_map<Vertex, double> map{radius.of_vertex.data()};
  if(settings.radius.adapts_by_direction)
  {
    radius.elongations.resize(mesh.num_vertices());
    with_parameters(limb_parameters(unused, radius.elongations), settings.estimation, attributes,
                    [&](const auto& np) { suggest_adaptive_radii<CGAL::Parallel_if_available_tag>(mesh, map, np); });
    return radius;
  }
  with_parameters(radius_parameters(unused), settings.estimation, attributes, [&](const auto& np) {
    if(settings.radius.is_adaptive)
      suggest_adaptive_radii<CGAL::Parallel_if_available_tag>(mesh, map, np);
    else
      suggest_geodesic_radii<CGAL::Parallel_if_available_tag>(mesh, map, np);
  });
  return radius;
}

Run<Estimate> estimate(const Mesh& mesh, Radius radius, const Settings& settings, const Mesh_attributes& attributes)
{
  const auto run_with = [&](const auto& np) {
    Run<Estimate> run{std::vector<Estimate>(mesh.num_vertices()), 0};
    CGAL::Real_timer preparation;
    preparation.start();
    const Curvature_estimator estimator(mesh, np, CGAL::Parallel_if_available_tag());
    const std::vector<Vertex> vertices =
      estimator.template vertices_in_spatial_order<CGAL::Parallel_if_available_tag>();
    run.seconds = preparation.time();
    run.seconds += for_each_vertex(vertices, settings.is_quiet ? "" : "Spider, radius " + radius.name, [&] {
      return [&, worker = estimator.worker()](Vertex v) mutable { run.answers[v] = worker(v); };
    });
    return run;
  };
  if(radius.elongations.empty())
    return with_parameters(radius_parameters(radius.of_vertex), settings.estimation, attributes, run_with);
  return with_parameters(limb_parameters(radius.of_vertex, radius.elongations), settings.estimation, attributes,
                         run_with);
}

} // namespace

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(auto e : mesh.edges())
    sum += CGAL::Polygon_mesh_processing::edge_length(mesh.halfedge(e), mesh);
  return sum / mesh.number_of_edges();
}

std::vector<Radius> choose_radii(const Mesh& mesh, const Settings& settings, const Mesh_attributes& attributes)
{
  constexpr double default_radius_in_edges = 4; // Spider's own
  const double edge_length = mean_edge_length(mesh);
  const Radius_settings& given = settings.radius;

  std::vector<Radius> radii;
  if(given.is_suggested || given.is_suggested_by_vertex || given.is_adaptive || given.adapts_by_direction)
    radii.push_back(suggested_radius(mesh, settings, attributes));
  if(!given.by_vertex.empty())
    radii.push_back(radius_of_file(given.by_vertex, mesh));
  for(double length : given.lengths)
    radii.push_back(constant_radius(short_number(length), mesh, length));
  for(double in_edges : given.in_edges)
    radii.push_back(constant_radius(short_number(in_edges) + "a", mesh, in_edges * edge_length));
  if(radii.empty())
    radii.push_back(
      constant_radius(short_number(default_radius_in_edges) + "a", mesh, default_radius_in_edges * edge_length));
  check_names(radii);
  return radii;
}

std::vector<Run<Estimate>> estimate(const Mesh& mesh, const std::vector<Radius>& radii, const Settings& settings,
                                    const Mesh_attributes& attributes)
{
  std::vector<Run<Estimate>> runs;
  for(const Radius& radius : radii) // each grows spiders of its own
    runs.push_back(estimate(mesh, radius, settings, attributes));
  return runs;
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
