// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How far the estimators agree with each other, and each with itself on other triangulations of the same surface, on
// meshes whose curvature nobody knows.

#include "Results.h"
#include "options.h"
#include "registry.h"
#include "stability.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <numeric>
#include <sstream>
#include <stdexcept>

using namespace CGAL::Spider::benchmark;
namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

struct Options : Estimator_options
{
  std::vector<std::string> meshes;
  std::vector<double> radii = {2, 4, 8};
};

Surface read_surface(const std::string& path)
{
  Surface surface;
  if(!PMP::IO::read_polygon_mesh(path, surface.mesh) || surface.mesh.is_empty())
    throw std::runtime_error("cannot read a mesh from " + path);
  PMP::triangulate_faces(surface.mesh);
  surface.mesh.collect_garbage();
  surface.mean_edge_length = mean_edge_length(surface.mesh);
  surface.border_distance = border_distances(surface.mesh);
  return surface;
}

// the median over estimators: no single one decides what the unit is
double common_rms_curvature(const std::vector<Timed_estimates>& all)
{
  std::vector<double> each;
  for(const auto& one : all)
    each.push_back(robust_rms_curvature(one.estimates));
  each.erase(std::remove_if(each.begin(), each.end(), [](double rms) { return std::isnan(rms); }), each.end());
  if(each.empty())
    throw std::runtime_error("no estimator found any curvature");
  std::nth_element(each.begin(), each.begin() + each.size() / 2, each.end());
  return each[each.size() / 2];
}

class Comparison
{
public:
  Comparison(const Options& options, std::string command_line)
    : options(options), estimators(select_estimators(options.estimators)), results("scan", std::move(command_line))
  {
    results.describe(estimators);
  }

  void run()
  {
    // a step for the mesh itself, and one for its other triangulations
    Progress progress(2 * options.meshes.size() * options.radii.size() * estimators.size(), options.no_progress);
    for(const auto& path : options.meshes)
    {
      const Surface surface = read_surface(path);
      const auto others = other_triangulations(surface.mesh);
      for(const double radius : options.radii)
        compare_at(std::filesystem::path(path).filename().string(), surface, others, radius, progress);
    }
  }

  void report() const
  {
    std::cout << table.str();
    if(!options.output.empty())
      results.write(options.output);
  }

private:
  using Triangulations = std::vector<std::pair<std::string, Mesh>>;

  void compare_at(const std::string& name, const Surface& surface, const Triangulations& others, double radius,
                  Progress& progress)
  {
    const double length = radius * surface.mean_edge_length;
    std::vector<Timed_estimates> all;
    for(const auto& estimator : estimators)
    {
      all.push_back(CGAL::Spider::benchmark::run(*estimator, surface.mesh, length));
      progress.step();
    }
    const double rms = common_rms_curvature(all);
    const auto interior = interior_vertices(surface, length);
    table << '\n'
          << name << ", " << surface.mesh.number_of_vertices() << " vertices, radius " << radius
          << " mean edge lengths: median changes of H in units of " << to_text(rms) << '\n'
          << std::setw(name_width) << "" << std::setw(width) << "flipped" << std::setw(width) << "remeshed"
          << std::setw(width) << "others" << std::setw(width) << "us/vertex" << '\n';
    for(std::size_t i = 0; i < estimators.size(); ++i)
    {
      const Row setting = {{"mesh", name}, {"mesh_vertices", surface.mesh.number_of_vertices()}, {"radius", radius}};
      table << std::left << std::setw(name_width) << estimators[i]->name() << std::right;
      for(const auto& other : others)
        add_change(setting, *estimators[i], all[i].estimates, surface, other, length, rms, interior);
      add_agreement(setting, i, all, rms, interior);
      add_time(setting, *estimators[i], all[i], surface);
      progress.step();
    }
  }

  void add_change(Row row, const Estimator& estimator, const std::vector<Estimate>& estimates, const Surface& surface,
                  const std::pair<std::string, Mesh>& other, double length, double rms,
                  const std::vector<Mesh::Vertex_index>& interior)
  {
    const auto there = CGAL::Spider::benchmark::run(estimator, other.second, length).estimates;
    const Errors change = compare(transfer(other.second, there, surface.mesh), estimates, interior, rms);
    row["estimator"] = estimator.name();
    row["change"] = other.first;
    append(row, change);
    results.add("stability", std::move(row));
    table << std::setw(width) << to_text(change.H.median);
  }

  // the median difference from every other estimator, and on the screen the median of these
  void add_agreement(const Row& setting, std::size_t i, const std::vector<Timed_estimates>& all, double rms,
                     const std::vector<Mesh::Vertex_index>& interior)
  {
    std::vector<double> differences;
    for(std::size_t j = 0; j < all.size(); ++j)
    {
      if(i == j)
        continue;
      const Errors difference = compare(all[i].estimates, all[j].estimates, interior, rms);
      Row row = setting;
      row["estimator"] = estimators[i]->name();
      row["other"] = estimators[j]->name();
      append(row, difference);
      results.add("agreement", std::move(row));
      if(!std::isnan(difference.H.median))
        differences.push_back(difference.H.median);
    }
    table << std::setw(width) << to_text(summarise(differences).median);
  }

  void add_time(Row row, const Estimator& estimator, const Timed_estimates& timed, const Surface& surface)
  {
    const double microseconds = 1e6 * timed.seconds / static_cast<double>(surface.mesh.number_of_vertices());
    row["estimator"] = estimator.name();
    row["microseconds"] = microseconds;
    results.add("time", std::move(row));
    table << std::setw(width) << to_text(microseconds) << '\n';
  }

  static constexpr int name_width = 24, width = 11;

  Options options;
  Estimators estimators;
  Results results;
  std::ostringstream table; // shown in the end: it would tear the progress bar apart
};

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Compares curvature estimators on meshes whose curvature isn't known.");
  Options options;
  options.add_to(app);
  app.add_option("meshes", options.meshes, "OFF, OBJ, PLY or STL files")->required()->check(CLI::ExistingFile);
  add_list(app, "--radii", options.radii, "Radii in mean edge lengths");
  CLI11_PARSE(app, argc, argv);
  if(options.quick && app.count("--radii") == 0)
    options.radii = {4};
  if(options.quick && app.count("--estimators") == 0)
    options.estimators = {"spider", "jet2_ball", "meyer", "rusinkiewicz"};

  return report_errors([&] {
    Comparison comparison(options, command_line(argc, argv));
    comparison.run();
    comparison.report();
  });
}
