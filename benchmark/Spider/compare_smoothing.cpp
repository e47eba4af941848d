// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How near smoothing brings noisy meshes to the clean ones (paper, figure 11).

#include "Results.h"
#include "noise.h"
#include "options.h"
#include "smoothers.h"
#include "surface_distance.h"
#include "tessellations.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

using namespace CGAL::Spider::benchmark;
namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

struct Options : Common_options
{
  std::vector<std::string> meshes;
  std::vector<double> amplitudes = {1};
  std::size_t seeds = 3;
  int rounds = 10;
};

Mesh read_mesh(const std::string& path)
{
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(path, mesh) || mesh.is_empty())
    throw std::runtime_error("cannot read a mesh from " + path);
  PMP::triangulate_faces(mesh);
  mesh.collect_garbage();
  return mesh;
}

// What a smoother of one strength made of one mesh, on average over the seeds.
struct Outcome
{
  double strength;
  double mean = 0, greatest = 0; // distances to the clean mesh, in units of its mean edge length
  double volume = 0;             // by how much it changed, in percent; NaN on meshes with borders
  double microseconds = 0;       // per vertex
};

class Comparison
{
public:
  Comparison(const Options& options, std::string command_line)
    : options(options), smoothers(all_smoothers()), results("smoothing", std::move(command_line))
  {
    for(const Smoother& smoother : smoothers)
      results.add("smoothers", {{"smoother", smoother.name}, {"settings", smoother.settings}});
  }

  void run()
  {
    std::size_t steps = 0;
    for(const Smoother& smoother : smoothers)
      steps += smoother.strengths.size();
    Progress progress(steps * options.meshes.size() * options.amplitudes.size(), options.no_progress);
    for(const auto& path : options.meshes)
    {
      const Mesh clean = read_mesh(path);
      for(const double amplitude : options.amplitudes)
        compare_on(std::filesystem::path(path).filename().string(), clean, amplitude, progress);
    }
  }

  void report() const
  {
    std::cout << table.str();
    if(!options.output.empty())
      results.write(options.output);
  }

private:
  void compare_on(const std::string& name, const Mesh& clean, double amplitude, Progress& progress)
  {
    const double edge = mean_edge_length(clean);
    std::vector<Mesh> noisy(options.seeds, clean);
    for(std::size_t seed = 0; seed < noisy.size(); ++seed)
    {
      Random random(seed + 1);
      add_noise(noisy[seed], area_weighted_normals(clean), edge, {amplitude}, random);
    }
    start_table(name, clean, amplitude);
    for(const Smoother& smoother : smoothers)
    {
      std::vector<Outcome> outcomes;
      for(const double strength : smoother.strengths)
      {
        outcomes.push_back(outcome_of(smoother, strength, clean, noisy));
        add_row(name, clean, amplitude, smoother, outcomes.back());
        progress.step();
      }
      add_line(smoother, outcomes);
    }
  }

  Outcome outcome_of(const Smoother& smoother, double strength, const Mesh& clean, const std::vector<Mesh>& noisy) const
  {
    const double edge = mean_edge_length(clean), share = 1 / static_cast<double>(noisy.size());
    const bool is_closed = CGAL::is_closed(clean);
    Outcome outcome{strength};
    for(const Mesh& before : noisy)
    {
      Mesh mesh = before;
      CGAL::Real_timer timer;
      timer.start();
      smoother.smooth(mesh, strength, options.rounds);
      timer.stop();
      const Surface_distance distance = surface_distance(mesh, clean);
      outcome.mean += share * distance.mean / edge;
      outcome.greatest += share * distance.greatest / edge;
      outcome.volume += share * (is_closed ? 100 * (PMP::volume(mesh) / PMP::volume(before) - 1)
                                           : std::numeric_limits<double>::quiet_NaN());
      outcome.microseconds += share * 1e6 * timer.time() / static_cast<double>(clean.number_of_vertices());
    }
    return outcome;
  }

  void add_row(const std::string& name, const Mesh& clean, double amplitude, const Smoother& smoother,
               const Outcome& outcome)
  {
    results.add("distance", {{"mesh", name},
                             {"mesh_vertices", clean.number_of_vertices()},
                             {"amplitude", amplitude},
                             {"smoother", smoother.name},
                             {"strength", outcome.strength},
                             {"mean", outcome.mean},
                             {"greatest", outcome.greatest},
                             {"volume_percent", outcome.volume},
                             {"microseconds", outcome.microseconds}});
  }

  void start_table(const std::string& name, const Mesh& clean, double amplitude)
  {
    table << '\n'
          << name << ", " << clean.number_of_vertices() << " vertices, noise of " << amplitude
          << " mean edge lengths, the unit of distances; each at its best by the mean and by the greatest distance\n"
          << std::setw(name_width) << "";
    for(const char* column :
        {"by mean", "mean", "greatest", "volume %", "us/vertex", "by greatest", "mean", "greatest"})
      table << std::setw(width) << column;
    table << '\n';
  }

  void add_line(const Smoother& smoother, const std::vector<Outcome>& outcomes)
  {
    const auto best = [&](double Outcome::*distance) {
      return *std::min_element(outcomes.begin(), outcomes.end(),
                               [&](const Outcome& a, const Outcome& b) { return a.*distance < b.*distance; });
    };
    const Outcome by_mean = best(&Outcome::mean), by_greatest = best(&Outcome::greatest);
    table << std::left << std::setw(name_width) << smoother.name << std::right;
    for(const double number : {by_mean.strength, by_mean.mean, by_mean.greatest})
      table << std::setw(width) << to_text(number);
    table << std::setw(width) << std::fixed << std::setprecision(3) << by_mean.volume;
    for(const double number : {by_mean.microseconds, by_greatest.strength, by_greatest.mean, by_greatest.greatest})
      table << std::setw(width) << to_text(number);
    table << '\n';
  }

  static constexpr int name_width = 20, width = 12;

  Options options;
  std::vector<Smoother> smoothers;
  Results results;
  std::ostringstream table; // shown in the end: it would tear the progress bar apart
};

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Compares how near smoothing brings noisy meshes to the clean ones.");
  Options options;
  options.add_to(app);
  app.add_option("meshes", options.meshes, "OFF, OBJ, PLY or STL files without noise")
    ->required()
    ->check(CLI::ExistingFile);
  add_list(app, "--amplitudes", options.amplitudes, "Noise, from end to end, in mean edge lengths");
  app.add_option("--seeds", options.seeds, "Noisy meshes of each kind")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app.add_option("--rounds", options.rounds, "Rounds of smoothing")->check(CLI::PositiveNumber)->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  if(options.quick && app.count("--seeds") == 0)
    options.seeds = 1;

  return report_errors([&] {
    Comparison comparison(options, command_line(argc, argv));
    comparison.run();
    comparison.report();
  });
}
