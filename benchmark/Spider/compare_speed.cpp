// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the estimators cost: time per vertex against the radius and against the size of the mesh, and memory.

#include "Results.h"
#include "Surface.h"
#include "options.h"
#include "peak_memory.h"
#include "registry.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <sstream>

using namespace CGAL::Spider::benchmark;

namespace {

struct Options : Estimator_options
{
  std::vector<double> radii = {1, 2, 4, 8};
  std::vector<std::size_t> sizes = {1000, 10000, 100000};
  double min_time = 0.2;
};

// the settings of the two sweeps: all radii at the middle size, all sizes at the middle radius
std::vector<std::pair<std::size_t, double>> settings(const Options& o)
{
  const std::size_t size = o.sizes[o.sizes.size() / 2];
  const double radius = o.radii[o.radii.size() / 2];
  std::vector<std::pair<std::size_t, double>> result;
  for(const double r : o.radii)
    result.emplace_back(size, r);
  for(const std::size_t n : o.sizes)
    if(n != size)
      result.emplace_back(n, radius);
  return result;
}

// Keeps what Google Benchmark finds: as results, and as its own table, which is shown in the end, since it would tear
// the progress bar apart.
class Recorder : public ::benchmark::ConsoleReporter
{
public:
  Recorder(Results& results, Progress& progress) : ConsoleReporter(OO_Tabular), results(results), progress(progress)
  {
    SetOutputStream(&table);
  }

  void print(std::ostream& out) const { out << table.str(); }

  void ReportRuns(const std::vector<Run>& runs) override
  {
    ConsoleReporter::ReportRuns(runs);
    progress.step();
    for(const Run& run : runs)
      if(run.run_type == Run::RT_Iteration && !run.error_occurred)
      {
        const double vertices = run.counters.at("vertices");
        results.add("speed", {{"estimator", run.run_name.function_name},
                              {"mesh_vertices", vertices},
                              {"radius", static_cast<double>(run.counters.at("radius"))},
                              {"microseconds", run.GetAdjustedCPUTime() / vertices},
                              {"peak_bytes", static_cast<double>(run.counters.at("bytes"))}});
      }
  }

private:
  Results& results;
  Progress& progress;
  std::ostringstream table;
};

// Irregular tori with a little noise: no borders, every valence, and nothing that one estimator finds easier than
// others.
Surface make_torus(std::size_t number_of_vertices)
{
  Recipe recipe;
  recipe.shape = "torus";
  recipe.tessellation = Tessellation::irregular;
  recipe.number_of_vertices = number_of_vertices;
  recipe.noise.amplitude = 0.25;
  return make_surface(recipe);
}

void measure(::benchmark::State& state, const Estimator& estimator, const Surface& surface, double radius)
{
  const double length = radius * surface.mean_edge_length;
  std::vector<Estimate> estimates;
  for(auto _ : state)
  {
    estimator.estimate(surface.mesh, length, estimates);
    ::benchmark::DoNotOptimize(estimates.data());
  }
  const double vertices = static_cast<double>(surface.mesh.number_of_vertices());
  state.counters["radius"] = radius;
  state.counters["vertices"] = vertices;
  state.counters["per_vertex"] =
    ::benchmark::Counter(vertices, ::benchmark::Counter::kIsIterationInvariantRate | ::benchmark::Counter::kInvert);
  state.counters["bytes"] =
    static_cast<double>(peak_memory([&] { estimator.estimate(surface.mesh, length, estimates); }));
}

void run_all(const Options& options, const std::string& command_line)
{
  const Estimators estimators = select_estimators(options.estimators);
  Results results("speed", command_line);
  results.describe(estimators);

  std::map<std::size_t, Surface> surfaces;
  for(const std::size_t size : options.sizes)
    surfaces.emplace(size, make_torus(size));
  for(const auto& estimator : estimators)
    for(const auto& setting : settings(options))
    {
      const Surface& surface = surfaces.at(setting.first);
      ::benchmark::RegisterBenchmark(
        estimator->name().c_str(),
        [&, radius = setting.second](::benchmark::State& state) { measure(state, *estimator, surface, radius); })
        ->Unit(::benchmark::kMicrosecond)
        ->MinTime(options.min_time);
    }

  Progress progress(estimators.size() * settings(options).size(), options.no_progress);
  Recorder recorder(results, progress);
  ::benchmark::RunSpecifiedBenchmarks(&recorder);
  recorder.print(std::cout);
  if(!options.output.empty())
    results.write(options.output);
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Measures the time and the memory that curvature estimators take. Google Benchmark's own options, "
               "--benchmark_..., are heeded too.");
  Options options;
  options.add_to(app);
  app.allow_extras();
  add_list(app, "--radii", options.radii, "Radii in mean edge lengths");
  add_list(app, "--sizes", options.sizes, "Numbers of vertices");
  app.add_option("--min-time", options.min_time, "Seconds for which each is repeated")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  if(options.quick)
  {
    if(app.count("--radii") == 0)
      options.radii = {1, 2, 4};
    if(app.count("--sizes") == 0)
      options.sizes = {500, 1000, 2000};
    if(app.count("--min-time") == 0)
      options.min_time = 0.01;
  }

  const std::string line = command_line(argc, argv);
  std::vector<std::string> extras = app.remaining();
  std::vector<char*> arguments = {argv[0]};
  for(auto& extra : extras)
    arguments.push_back(extra.data());
  int count = static_cast<int>(arguments.size());
  ::benchmark::Initialize(&count, arguments.data());
  if(::benchmark::ReportUnrecognizedArguments(count, arguments.data()))
    return EXIT_FAILURE;

  return report_errors([&] { run_all(options, line); });
}
