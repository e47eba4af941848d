// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Estimates the curvature of a mesh file at every vertex and writes it to files that other programs show; --help tells
// all that it does.

#include "Limbs.h"
#include "Report.h"
#include "command_line.h"
#include "for_each_vertex.h"
#include "read_mesh.h"
#include "render.h"
#include "write_table.h"

#include <CGAL/Spider/classify_vertices.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>

namespace {

namespace Spider = CGAL::Spider;
namespace tool = CGAL::Spider::tool;
using tool::Mesh;
using tool::Vertex;

// Whether files can be written is found out late, but what their names ask for is known at once.
void check_file_names(const tool::Settings& settings)
{
  if(!settings.output.empty() && !tool::is_table_file(settings.output))
    throw std::invalid_argument("--output is " + settings.output + ": give a name that ends in .ply, .vtp or .csv");
  for(const auto& [option, file] :
      {std::pair("--isolines-output is ", settings.isolines_output), std::pair("--ridges is ", settings.ridges.file),
       std::pair("--limbs-output is ", settings.limbs.file)})
    if(!file.empty() && !tool::is_polylines_file(file))
      throw std::invalid_argument(option + file + ": give a name that ends in .vtp or .obj");
}

Mesh read_mesh(const std::string& file)
{
  Mesh mesh = tool::read_mesh(file);
  const double edge_length = tool::mean_edge_length(mesh);
  if(!(edge_length > 0 && std::isfinite(edge_length)))
    throw tool::Unusable_mesh(file, "has no edges of positive, finite length");
  return mesh;
}

void write_mesh(const std::string& file, const Mesh& mesh)
{
  if(!CGAL::IO::write_polygon_mesh(file, mesh,
                                   CGAL::parameters::stream_precision(std::numeric_limits<double>::max_digits10)))
    throw tool::File_error(file, "can't be written (its name must end in .off, .obj, .ply or .stl)");
}

// without the time of its preparation, which gives it the orientation of the surface and is no part of jet fitting
tool::Run<tool::Jet_estimate> run_jets(const Mesh& mesh, const std::vector<double>& radius_of_vertex, bool is_quiet)
{
  tool::Run<tool::Jet_estimate> run{std::vector<tool::Jet_estimate>(mesh.num_vertices()), 0};
  const tool::Jet_estimator estimator(mesh, radius_of_vertex);
  const std::vector<Vertex> vertices(mesh.vertices().begin(), mesh.vertices().end());
  run.seconds = tool::for_each_vertex(vertices, is_quiet ? "" : "Jet fitting",
                                      [&] { return [&](Vertex v) { run.answers[v] = estimator(v); }; });
  return run;
}

tool::Labels classify(const Mesh& mesh, const tool::Run<tool::Estimate>& run, const std::optional<double>& threshold)
{
  tool::Labels labels{std::vector<Spider::Vertex_label>(mesh.num_vertices()), 0};
  const tool::Array_map<Vertex, const tool::Estimate> estimates{run.answers.data()};
  const tool::Array_map<Vertex, Spider::Vertex_label> label_map{labels.of_vertex.data()};
  labels.threshold = threshold ? Spider::classify_vertices(mesh, estimates, label_map,
                                                           Spider::parameters::flatness_threshold(*threshold))
                               : Spider::classify_vertices(mesh, estimates, label_map);
  return labels;
}

// A file that is there as long as this is.
class Temporary_file
{
public:
  explicit Temporary_file(const std::string& beside) : m_path(beside + ".tmp.vtp") {}
  ~Temporary_file() { std::remove(m_path.c_str()); }
  const std::string& path() const { return m_path; }

private:
  std::string m_path;
};

void write_files(const Mesh& mesh, const tool::Settings& settings, tool::Report& report)
{
  const auto table = tool::make_table(report.runs, report.radii, report.labels, settings.colour_by);
  if(!settings.mesh_output.empty())
  {
    write_mesh(settings.mesh_output, mesh);
    report.written_files.push_back(settings.mesh_output);
  }
  if(!settings.output.empty())
  {
    tool::write_table(settings.output, mesh, table);
    report.written_files.push_back(settings.output);
  }
  if(!settings.isolines.empty())
  {
    tool::write_polylines(settings.isolines_output, tool::polylines(report.isolines));
    report.written_files.push_back(settings.isolines_output);
  }
  if(report.ridges)
  {
    tool::write_polylines(settings.ridges.file, tool::polylines(*report.ridges));
    report.written_files.push_back(settings.ridges.file);
  }
  if(!settings.picture.file.empty())
  {
    const Temporary_file vtp(settings.picture.file);
    tool::write_table(vtp.path(), mesh, table);
    const bool has_suffix = report.runs.size() > 1;
    tool::render(vtp.path(), settings.colour_by + (has_suffix ? "_r" + report.radii.front().name : ""),
                 settings.picture);
    report.written_files.push_back(settings.picture.file);
  }
}

void write_limbs(const Mesh& mesh, const tool::Settings& settings, const tool::Mesh_attributes& attributes,
                 tool::Report& report)
{
  const auto limbs =
    tool::trace_limbs(mesh, report.runs.front().answers, report.radii.front().of_vertex, settings, attributes);
  tool::write_polylines(settings.limbs.file, tool::polylines(limbs));
  report.written_files.push_back(settings.limbs.file);
}

void run(const tool::Settings& settings)
{
  check_file_names(settings);
  Mesh mesh = read_mesh(settings.mesh);
  tool::Report report;
  report.mesh_file = settings.mesh;
  report.vertices = mesh.number_of_vertices();
  report.faces = mesh.number_of_faces();

  const tool::Mesh_attributes attributes = tool::mesh_attributes(mesh, settings);
  report.feature_edges = attributes.number_of_features();
  if(settings.smoothing.rounds)
    report.smoothing = tool::smooth(mesh, settings.smoothing, attributes);
  report.mean_edge_length = tool::mean_edge_length(mesh);

  report.radii = tool::choose_radii(mesh, settings, attributes);
  report.runs = tool::estimate(mesh, report.radii, settings, attributes);
  if(settings.compares_with_jets)
    report.jets = run_jets(mesh, report.radii.front().of_vertex, settings.is_quiet);
  if(settings.labels || settings.colour_by == "label")
    for(const auto& each : report.runs)
      report.labels.push_back(classify(mesh, each, settings.flatness_threshold));
  report.isolines = tool::find_isolines(mesh, report.runs.front().answers, settings.isolines);
  if(!settings.ridges.file.empty())
    report.ridges =
      tool::find_ridges(mesh, report.runs.front().answers, report.radii.front().of_vertex, settings.ridges);

  write_files(mesh, settings, report);
  if(!settings.limbs.vertices.empty())
    write_limbs(mesh, settings, attributes, report);
  if(settings.is_json)
    std::cout << tool::to_json(report).dump(2) << '\n';
  else if(!settings.is_quiet)
    tool::print(std::cout, report);
}

// The library says who it is in front of what it refuses, and so does this program.
std::string without_prefix(const std::string& message)
{
  const std::string prefix = "Spider: ";
  return message.compare(0, prefix.size(), prefix) == 0 ? message.substr(prefix.size()) : message;
}

int fail(tool::Exit_code code, const std::exception& error)
{
  std::cerr << "spider: " << without_prefix(error.what()) << '\n';
  return code;
}

} // namespace

int main(int argc, char* argv[])
{
  tool::Settings settings;
  CLI::App app;
  tool::describe_command_line(app, settings);
  if(argc == 3 && std::string(argv[1]) == "--manual-page") // for the build, which installs it
    return std::ofstream(argv[2]) << tool::manual_page(app) << std::flush ? tool::success : tool::unwritten_file;

  try
  {
    app.parse(argc, argv);
    run(settings);
    return tool::success;
  }
  catch(const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? tool::success : tool::wrong_usage; // 0 is what asking for help gives
  }
  catch(const tool::Unusable_mesh& error)
  {
    return fail(tool::unusable_mesh, error);
  }
  catch(const tool::File_error& error)
  {
    return fail(tool::unwritten_file, error);
  }
  catch(const std::invalid_argument& error)
  {
    return fail(tool::wrong_usage, error);
  }
  catch(const std::exception& error)
  {
    return fail(tool::other_failure, error);
  }
}
