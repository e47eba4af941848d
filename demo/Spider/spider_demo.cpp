// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Estimates the curvature of a mesh file at every vertex, sets it beside CGAL's jet fitting, and writes it as a PLY
// file.

#include "Jet_estimator.h"
#include "for_each_vertex.h"
#include "read_mesh.h"
#include "summary.h"
#include "write_mesh.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Spider.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>

namespace {

namespace Spider = CGAL::Spider;
namespace demo = CGAL::Spider::demo;
using demo::Mesh;
using demo::Vertex;

struct Options
{
  std::string mesh;
  std::string output = "curvature.ply";
  double radius_in_edges = 4; // Spider's own default
};

// CLI11's own check would tell the greatest number there is, digit by digit.
std::string is_positive(const std::string& text)
{
  const double value = std::strtod(text.c_str(), nullptr);
  return value > 0 && std::isfinite(value) ? "" : text + " is no positive number";
}

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(auto e : mesh.edges())
    sum += CGAL::Polygon_mesh_processing::edge_length(mesh.halfedge(e), mesh);
  return sum / mesh.number_of_edges();
}

demo::Run<demo::Estimate> run_spider(const Mesh& mesh, double radius)
{
  demo::Run<demo::Estimate> run{std::vector<demo::Estimate>(mesh.num_vertices()), 0};
  CGAL::Real_timer preparation;
  preparation.start();
  const Spider::Curvature_estimator estimator(mesh, Spider::parameters::geodesic_radius(radius));
  run.seconds = preparation.time();
  run.seconds += demo::for_each_vertex(mesh, "Spider", [&] {
    return [&, worker = estimator.worker()](Vertex v) mutable { run.answers[v] = worker(v); };
  });
  return run;
}

// without the time of its preparation, which gives it the orientation of the surface and is no part of jet fitting
demo::Run<demo::Jet_estimate> run_jets(const Mesh& mesh, double radius)
{
  demo::Run<demo::Jet_estimate> run{std::vector<demo::Jet_estimate>(mesh.num_vertices()), 0};
  const demo::Jet_estimator estimator(mesh, radius);
  run.seconds = demo::for_each_vertex(mesh, "Jet fitting", [&] {
    return [&](Vertex v) { run.answers[v] = estimator(v); };
  });
  return run;
}

int run_demo(const Options& options)
{
  const Mesh mesh = demo::read_mesh(options.mesh);
  const double radius = options.radius_in_edges * mean_edge_length(mesh);
  if(!(radius > 0 && std::isfinite(radius)))
    throw demo::Unusable_mesh(options.mesh, "has no edges of positive, finite length");
  std::cout << options.mesh << ": " << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces()
            << " triangles\nradius " << radius << ", " << options.radius_in_edges << " mean edge lengths" << std::endl;

  const auto spider = run_spider(mesh, radius);
  const auto jets = run_jets(mesh, radius);
  std::cout << '\n';
  demo::print_summary(std::cout, spider, jets);

  if(!demo::write_mesh(options.output, mesh, spider.answers))
    throw std::runtime_error(options.output + ": can't be written");
  std::cout << "\nAll estimates are in " << options.output << ", H as its colour: blue concave, red convex.\n";
  return 0;
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app("Estimates the curvature of a mesh with Spider, beside CGAL's jet fitting.");
  app.add_option("mesh", options.mesh, "an OFF, OBJ, PLY or STL file")->required();
  app.add_option("--radius-in-edges", options.radius_in_edges, "geodesic radius, in mean edge lengths of the mesh")
    ->check(is_positive)
    ->capture_default_str();
  app.add_option("--output", options.output, "the PLY file to write")->capture_default_str();

  try
  {
    app.parse(argc, argv);
    return run_demo(options);
  }
  catch(const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : 1; // 0 is what asking for help gives
  }
  catch(const std::exception& error)
  {
    std::cerr << "spider_demo: " << error.what() << '\n';
    return 1;
  }
}
