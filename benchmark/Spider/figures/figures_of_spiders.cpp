// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures 1, 2 and 4: spiders themselves.

#include "../tessellations.h"
#include "Figure.h"
#include "figure_estimates.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Spider/estimate_normal.h>
#include <CGAL/Spider/resample.h>
#include <CGAL/Spider/trace_limbs.h>
#include <CGAL/Spider/trace_sphere_section.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

const Point place_on_the_elephant(0.14, 0.14, 0.1); // on its chest, of middling curvature

using Limbs = std::vector<Limb_3<Mesh>>;
using Polylines = std::vector<std::vector<Point>>;

template <typename NamedParameters>
Limbs limbs_at(Mesh::Vertex_index v, const Vector& normal, const Mesh& mesh, const NamedParameters& np)
{
  Limbs limbs;
  trace_limbs(v, normal, mesh, std::back_inserter(limbs), np);
  return limbs;
}

Polylines polylines(const Limbs& limbs)
{
  Polylines lines;
  for(const auto& limb : limbs)
    lines.push_back(limb.polyline);
  return lines;
}

double worst_length(const Limbs& limbs, double radius)
{
  double worst = 0;
  for(const auto& limb : limbs)
    worst = std::max(worst, std::abs(limb.length - radius));
  return worst;
}

} // namespace

Figure figure_1(const Figure_input& input)
{
  constexpr double radius_in_edges = 4;
  constexpr unsigned int directions = 4; // a quarter of pi apart
  const Mesh mesh = input.mesh("elephant.off");
  const double radius = radius_in_edges * mean_edge_length(mesh);
  const auto v = nearest_vertex(mesh, place_on_the_elephant);
  const Vector normal = estimate_normal(v, mesh, parameters::geodesic_radius(radius));
  const Limbs limbs = limbs_at(v, normal, mesh, parameters::geodesic_radius(radius).number_of_directions(directions));

  Polylines resampled;
  std::vector<Point> samples;
  for(const auto& limb : limbs)
  {
    resampled.push_back(resample(limb, radius / 10));
    samples.insert(samples.end(), resampled.back().begin(), resampled.back().end());
  }
  Figure figure(1, "Limbs of a spider for an angular step of \u03c0/4");
  figure.add_mesh("mesh", mesh);
  for(const bool are_resampled : {false, true})
  {
    figure.add_panel(are_resampled ? "resampled at r / 10" : "polylines of intersection", "mesh");
    figure.add_lines("limb", are_resampled ? resampled : polylines(limbs));
    figure.add_lines("normal", {{mesh.point(v), mesh.point(v) + radius / 2 * normal}});
    figure.add_points("query", {mesh.point(v)});
    if(are_resampled)
      figure.add_points("sample", samples);
    figure.set("radius", radius);
    figure.set("direction", {normal.x(), normal.y(), normal.z()});
  }
  figure.add_claim("limbs for a step of \u03c0/4", "8", std::to_string(limbs.size()), limbs.size() == 8);
  const double worst = worst_length(limbs, radius) / radius;
  figure.add_claim("greatest difference of a limb's length from r", "0 (the last segment is shortened)",
                   digits(worst) + " r", worst < 1e-12);
  return figure;
}

Figure figure_2(const Figure_input& input)
{
  constexpr double radius_in_edges = 3.5;
  const Mesh mesh = input.mesh("elephant.off");
  const double radius = radius_in_edges * mean_edge_length(mesh);
  const auto v = nearest_vertex(mesh, place_on_the_elephant);
  const auto section = trace_sphere_section(v, mesh, parameters::geodesic_radius(radius));
  const Vector normal = estimate_normal(v, mesh, parameters::geodesic_radius(radius).first_normal(sphere_section));
  const Vector iterated = estimate_curvature(v, mesh, parameters::geodesic_radius(radius)).normal;

  Figure figure(2, "The normal from the intersection with a sphere");
  figure.add_mesh("mesh", mesh);
  figure.add_panel("", "mesh");
  std::vector<Point> on_section;
  for(const auto& line : section)
  {
    figure.add_lines("section", {line});
    on_section.insert(on_section.end(), line.begin(), line.end());
  }
  double worst = 0;
  for(const Point& p : on_section)
    worst = std::max(worst, std::abs(std::sqrt(CGAL::squared_distance(p, mesh.point(v))) - radius));
  figure.add_lines("normal", {{mesh.point(v), mesh.point(v) + radius * normal}});
  figure.add_points("query", {mesh.point(v)});
  figure.add_points("centroid", {CGAL::centroid(on_section.begin(), on_section.end())});
  figure.set("radius", radius);
  figure.set("direction", {normal.x(), normal.y(), normal.z()});
  figure.add_number("greatest distance of the section's vertices from the sphere", digits(worst / radius) + " r");
  figure.add_number("angle between this normal and the one that curvature is estimated with, after iteration",
                    digits(angle(normal, iterated)) + " rad");
  return figure;
}

Figure figure_4(const Figure_input& input)
{
  constexpr double feature_angle = 40; // degrees
  constexpr unsigned int directions = 8;
  Mesh mesh = input.mesh("fandisk.off");
  const double radius = 12 * mean_edge_length(mesh); // some cross the edge, and some don't reach it
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, feature_angle, is_feature);
  std::vector<std::vector<Point>> features;
  for(auto e : mesh.edges())
    if(is_feature[e])
      features.push_back({mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))});

  const auto v = nearest_vertex(mesh, Point(-0.1, 0.1, 0.5));
  const Vector normal = estimate_normal(v, mesh, parameters::first_normal(incident_faces));
  const auto chain = parameters::geodesic_radius(radius).number_of_directions(directions);
  const Limbs isotropic = limbs_at(v, normal, mesh, chain);
  const Limbs anisotropic = limbs_at(v, normal, mesh, chain.edge_is_constrained_map(is_feature));

  Figure figure(4, "A spider that ignores feature edges, and one that heeds them");
  figure.add_mesh("mesh", mesh);
  for(const Limbs* limbs : {&isotropic, &anisotropic})
  {
    figure.add_panel(limbs == &isotropic ? "isotropic" : "anisotropic", "mesh");
    figure.add_lines("limb", polylines(*limbs));
    figure.add_lines("feature", features);
    figure.add_points("query", {mesh.point(v)});
    figure.set("radius", radius);
    figure.set("direction", {normal.x(), normal.y(), normal.z()});
  }
  const auto ends =
    std::count_if(anisotropic.begin(), anisotropic.end(), [](const auto& limb) { return limb.end == feature_edge; });
  figure.add_claim("limbs that end at a feature edge", "some, where features are heeded",
                   std::to_string(ends) + " of " + std::to_string(anisotropic.size()), ends > 0);
  return figure;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
