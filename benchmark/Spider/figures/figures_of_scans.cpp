// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures 8, 9 and 10: scans, of which nobody knows the curvature.

#include "../estimators/Taubin_1995.h"
#include "../tessellations.h"
#include "Figure.h"
#include "figure_estimates.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Spider/classify_vertices.h>
#include <CGAL/Spider/derived_fields.h>
#include <CGAL/Spider/extract_isolines.h>

#include <array>
#include <iterator>
#include <sstream>

namespace CGAL {
namespace Spider {
namespace benchmark {

Figure figure_8(const Figure_input& input)
{
  const Mesh mesh = input.mesh("armadillo.off");
  const double a = mean_edge_length(mesh);
  const auto at_1 = mean_curvatures(estimate(mesh, a));
  const auto at_4 = mean_curvatures(estimate(mesh, 4 * a));

  Figure figure(8, "A dense mesh from a scan, and its mean curvature");
  figure.add_mesh("mesh", mesh);
  figure.add_panel("the mesh", "mesh");
  figure.add_panel("H, r = 4 a", "mesh");
  figure.add_field("H", at_4);
  const double rough_1 = roughness(mesh, at_1), rough_4 = roughness(mesh, at_4);
  figure.add_claim("roughness of H (median difference from the neighbours' mean, over the median of |H|)",
                   "smooth at 4 a", digits(rough_4) + " at 4 a, " + digits(rough_1) + " at a", rough_4 < rough_1);
  return figure;
}

Figure figure_9(const Figure_input& input)
{
  constexpr double no_radius = 0;
  const Mesh mesh = input.mesh("bunny00.off");
  const double a = mean_edge_length(mesh);
  std::vector<Estimate> taubin;
  Taubin_1995().estimate(mesh, no_radius, taubin);

  Figure figure(9, "Gaussian curvature of a scan");
  figure.add_mesh("mesh", mesh);
  std::vector<double> rough;
  const auto add = [&](const std::string& title, const std::vector<double>& field) {
    figure.add_panel(title, "mesh");
    figure.add_field("K", field);
    rough.push_back(roughness(mesh, field));
  };
  add("Taubin 1995", Gaussian_curvatures(taubin));
  for(int r : {1, 4, 8})
    add("Spider, r = " + (r == 1 ? "" : std::to_string(r) + " ") + "a", Gaussian_curvatures(estimate(mesh, r * a)));
  figure.add_claim("roughness of K (median difference from the neighbours' mean, over the median of |K|)",
                   "falls from Taubin's through 1, 4 and 8 a",
                   digits(rough[0]) + "; " + digits(rough[1]) + ", " + digits(rough[2]) + ", " + digits(rough[3]),
                   rough[0] > rough[1] && rough[1] > rough[2] && rough[2] > rough[3]);
  return figure;
}

Figure figure_10(const Figure_input& input)
{
  const Mesh mesh = input.mesh("armadillo.off");
  const auto estimates = estimate(mesh, 3 * mean_edge_length(mesh));
  const auto map = boost::make_iterator_property_map(estimates.begin(), get(boost::vertex_index, mesh));
  std::vector<Vertex_label> labels(mesh.num_vertices());
  const double threshold =
    classify_vertices(mesh, map, boost::make_iterator_property_map(labels.begin(), get(boost::vertex_index, mesh)));

  Figure figure(10, "Features of a scan");
  figure.add_mesh("mesh", mesh);
  figure.add_panel("feature map", "mesh");
  figure.add_field("label", std::vector<double>(labels.begin(), labels.end()));
  figure.add_panel("curves of equal curvature", "mesh");
  const auto min_curvature = boost::make_function_property_map<Mesh::Vertex_index>(
    [&](Mesh::Vertex_index v) { return estimates[v].min_curvature; });
  const auto max_curvature = boost::make_function_property_map<Mesh::Vertex_index>(
    [&](Mesh::Vertex_index v) { return estimates[v].max_curvature; });
  std::size_t count = 0, closed = 0;
  const auto add_lines = [&](const std::string& kind, const auto& field, double value) {
    std::vector<Isoline_3<Mesh>> isolines;
    extract_isolines(mesh, field, value, std::back_inserter(isolines));
    std::vector<std::vector<Point>> lines;
    for(const auto& isoline : isolines)
    {
      lines.push_back(isoline.points);
      closed += isoline.is_closed;
    }
    count += lines.size();
    figure.add_lines(kind, lines);
  };
  add_lines("ridge", max_curvature, 2 * threshold);
  add_lines("valley", min_curvature, -2 * threshold);

  std::array<double, unlabelled + 1> area = {};
  for(auto face : mesh.faces())
    for(auto v : mesh.vertices_around_face(mesh.halfedge(face)))
      area[labels[v]] += CGAL::Polygon_mesh_processing::face_area(face, mesh) / 3;
  const double whole = CGAL::Polygon_mesh_processing::area(mesh);
  std::ostringstream shares;
  for(Vertex_label label : {convex, concave, flat, saddle})
    shares << (label == convex ? "" : ", ") << digits(100 * area[label] / whole) << " % " << label;
  figure.add_number("share of the area by label", shares.str());
  figure.add_claim("curves of equal curvature on a closed surface", "extracted from the feature map",
                   std::to_string(count) + ", of which " + std::to_string(closed) + " are closed", count == closed);
  return figure;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
