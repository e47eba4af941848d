// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What estimators cost: time per vertex against the radius and against the size of the mesh, and memory. Either Spider
// beside others, or beside itself on other types of meshes, with other directions and more threads.

#include "Results.h"
#include "Surface.h"
#include "mesh_types.h"
#include "options.h"
#include "peak_memory.h"
#include "read_mesh.h"
#include "registry.h"

#include <benchmark/benchmark.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

using namespace CGAL::Spider::benchmark;

namespace {

struct Options : Estimator_options
{
  std::vector<std::string> meshes;
  std::vector<double> radii = {1, 2, 4, 8, 16};
  std::vector<std::size_t> sizes = {10000, 100000};
  double min_time = 0.2;
  bool variants = false;
  std::vector<std::string> mesh_types;
  std::vector<int> directions = {0, 16};
#ifdef CGAL_LINKED_WITH_TBB
  std::vector<int> threads = {1, 2};
#else
  std::vector<int> threads = {1};
#endif
};

struct Subject
{
  std::string name;
  Mesh mesh;
  double mean_edge_length;
};

// Irregular tori with a little noise: no borders, every valence, and nothing that one estimator finds easier than
// others.
Subject torus(std::size_t number_of_vertices)
{
  Recipe recipe;
  recipe.shape = "torus";
  recipe.tessellation = Tessellation::irregular;
  recipe.number_of_vertices = number_of_vertices;
  recipe.noise.amplitude = 0.25;
  Surface surface = make_surface(recipe);
  return {"torus", std::move(surface.mesh), surface.mean_edge_length};
}

std::vector<Subject> make_subjects(const Options& options)
{
  std::vector<Subject> subjects;
  for(const auto& path : options.meshes)
  {
    Mesh mesh = read_mesh(path);
    const double edge = mean_edge_length(mesh);
    subjects.push_back({std::filesystem::path(path).filename().string(), std::move(mesh), edge});
  }
  if(options.meshes.empty())
    for(const std::size_t size : options.sizes)
      subjects.push_back(torus(size));
  return subjects;
}

struct Setting
{
  const Subject& subject;
  double radius; // in mean edge lengths

  double length() const { return radius * subject.mean_edge_length; }
};

// The two sweeps: all radii on the first mesh, and the middle radius on all of them.
std::vector<Setting> settings(const std::vector<Subject>& subjects, const std::vector<double>& radii)
{
  std::vector<Setting> result;
  for(const double radius : radii)
    result.push_back({subjects.front(), radius});
  for(std::size_t i = 1; i < subjects.size(); ++i)
    result.push_back({subjects[i], radii[radii.size() / 2]});
  return result;
}

// One thing to measure.
struct Case
{
  std::string name; // in Google Benchmark's table, unique
  Row row;          // in the results, before what is measured
  double vertices;
  std::function<void()> work;
  double peak_bytes = 0;

  Case(const std::string& what, Row what_row, const Setting& setting, std::function<void()> work)
    : row(std::move(what_row)), vertices(static_cast<double>(setting.subject.mesh.number_of_vertices())),
      work(std::move(work))
  {
    std::ostringstream text;
    text << what << '/' << setting.subject.name << "/n:" << setting.subject.mesh.number_of_vertices()
         << "/r:" << setting.radius;
    name = text.str();
    row["mesh"] = setting.subject.name;
    row["mesh_vertices"] = vertices;
    row["radius"] = setting.radius;
  }
};
using Cases = std::vector<Case>;

Cases cases_of_estimators(const Options& options, const Estimators& estimators, const std::vector<Subject>& subjects)
{
  Cases cases;
  for(const auto& estimator : estimators)
    for(const Setting& setting : settings(subjects, options.radii))
      cases.emplace_back(estimator->name(), Row{{"estimator", estimator->name()}}, setting,
                         [&estimator = *estimator, setting] {
                           std::vector<Estimate> estimates;
                           estimator.estimate(setting.subject.mesh, setting.length(), estimates);
                           ::benchmark::DoNotOptimize(estimates.data());
                         });
  return cases;
}

void add_variants(const Mesh_type& type, const Options& options, const std::vector<Subject>& subjects, Cases& cases)
{
  std::map<const Subject*, Spider_run> runs;
  for(const Subject& subject : subjects)
    runs.emplace(&subject, type.run_on_copy_of(subject.mesh));
  for(const int directions : options.directions)
    for(const int threads : options.threads)
      for(const Setting& setting : settings(subjects, options.radii))
        cases.emplace_back(
          type.name + "/directions:" + std::to_string(directions) + "/threads:" + std::to_string(threads),
          Row{{"mesh_type", type.name}, {"directions", directions}, {"threads", threads}}, setting,
          [run = runs.at(&setting.subject), of_run = Spider_settings{setting.length(), directions, threads}] {
            ::benchmark::DoNotOptimize(run(of_run));
          });
}

Cases cases_of_variants(const Options& options, const std::vector<Subject>& subjects)
{
  const auto is_selected = [&](const Mesh_type& type) {
    const auto is_part = [&](const std::string& name) { return boost::algorithm::icontains(type.name, name); };
    return options.mesh_types.empty() || std::any_of(options.mesh_types.begin(), options.mesh_types.end(), is_part);
  };
  Cases cases;
  std::string known;
  for(const Mesh_type& type : all_mesh_types())
  {
    known += known.empty() ? type.name : ", " + type.name;
    if(is_selected(type))
      add_variants(type, options, subjects, cases);
  }
  if(cases.empty())
    throw std::invalid_argument("no type of meshes is called that; there are: " + known);
  return cases;
}

// Keeps what Google Benchmark finds: as results, and as its own table, which is shown in the end, since it would tear
// the progress bar apart.
class Recorder : public ::benchmark::ConsoleReporter
{
public:
  Recorder(const Cases& cases, Results& results, Progress& progress)
    : ConsoleReporter(OO_Tabular), cases(cases), results(results), progress(progress)
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
        const auto has_its_name = [&](const Case& one) { return one.name == run.run_name.function_name; };
        const Case& measured = *std::find_if(cases.begin(), cases.end(), has_its_name);
        Row row = measured.row;
        row["microseconds"] = run.GetAdjustedCPUTime() / measured.vertices;
        row["clock_microseconds"] = run.GetAdjustedRealTime() / measured.vertices;
        row["peak_bytes"] = measured.peak_bytes;
        results.add("speed", row);
      }
  }

private:
  const Cases& cases;
  Results& results;
  Progress& progress;
  std::ostringstream table;
};

void measure(::benchmark::State& state, const Case& measured)
{
  using ::benchmark::Counter;
  for(auto _ : state)
    measured.work();
  state.counters["per_vertex"] = Counter(measured.vertices, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["bytes"] = measured.peak_bytes;
}

void measure_all(Cases cases, const Options& options, Results& results)
{
  Progress progress(2 * cases.size(), options.no_progress);
  // memory first: that is measured in a child process, in which threads that were started before aren't there
  for(Case& measured : cases)
  {
    measured.peak_bytes = static_cast<double>(peak_memory(measured.work));
    progress.step();
  }
  for(const Case& measured : cases)
  {
    auto* const benchmark = ::benchmark::RegisterBenchmark(
      measured.name.c_str(), [&](::benchmark::State& state) { measure(state, measured); });
    benchmark->Unit(::benchmark::kMicrosecond)->MinTime(options.min_time);
    if(options.variants) // whose threads are to save real time, and may take more of the processor's
      benchmark->UseRealTime()->MeasureProcessCPUTime();
  }
  Recorder recorder(cases, results, progress);
  ::benchmark::RunSpecifiedBenchmarks(&recorder);
  recorder.print(std::cout);
}

void run_all(const Options& options, const std::string& command_line)
{
  const std::vector<Subject> subjects = make_subjects(options);
  Results results(options.variants ? "variants" : "speed", command_line);
  if(options.variants)
    measure_all(cases_of_variants(options, subjects), options, results);
  else
  {
    const Estimators estimators = select_estimators(options.estimators);
    results.describe(estimators);
    measure_all(cases_of_estimators(options, estimators, subjects), options, results);
  }
  if(!options.output.empty())
    results.write(options.output);
}

void add_options(CLI::App& app, Options& options)
{
  options.add_to(app);
  app.add_option("meshes", options.meshes, "OFF, OBJ, PLY or STL files, rather than tori")->check(CLI::ExistingFile);
  add_list(app, "--radii", options.radii, "Radii in mean edge lengths: all on the first mesh, the middle one on all");
  add_list(app, "--sizes", options.sizes, "Numbers of the tori's vertices");
  app.add_option("--min-time", options.min_time, "Seconds for which each is repeated")->capture_default_str();
  auto* const variants = app.add_flag("--variants", options.variants, "Compare Spider with itself, not with others");
  add_list(app, "--mesh-types", options.mesh_types, "Variants: parts of names, as Polyhedron_3<float>; all by default")
    ->needs(variants);
  add_list(app, "--directions", options.directions, "Variants: numbers of directions, 0 being the default")
    ->needs(variants);
  add_list(app, "--threads", options.threads, "Variants: numbers of threads")
    ->check(CLI::PositiveNumber)
    ->needs(variants);
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Measures the time and the memory that curvature estimators take. Google Benchmark's own options, "
               "--benchmark_..., are heeded too.");
  Options options;
  add_options(app, options);
  app.allow_extras();
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
