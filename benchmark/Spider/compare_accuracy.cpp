// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How wrong the estimators are on surfaces whose curvature is known.

#include "Averages.h"
#include "Results.h"
#include "Surface.h"
#include "options.h"
#include "registry.h"

#include <algorithm>

using namespace CGAL::Spider::benchmark;

namespace {

struct Options : Common_options
{
  std::vector<std::string> shapes = {"sphere", "torus", "ellipsoid", "saddle", "waves"};
  std::vector<std::string> tessellations = tessellation_names();
  std::vector<double> noise = {0, 0.25, 0.5, 1};
  std::vector<double> radii = {2, 4, 8};
  std::size_t vertices = 10000;
  std::size_t seeds = 1;
  bool gaussian = false;
  double outliers = 0;
};

void read_options(CLI::App& app, Options& o)
{
  o.add_to(app);
  app
    .add_option("--shapes", o.shapes,
                "Of sphere, torus, ellipsoid, saddle, waves, cylinder, monkey_saddle, implicit; or all")
    ->delimiter(',')
    ->capture_default_str();
  app.add_option("--tessellations", o.tessellations, "Of regular, irregular, slivers")
    ->delimiter(',')
    ->capture_default_str();
  app.add_option("--noise", o.noise, "Amplitudes in mean edge lengths; 1 is the paper's")
    ->delimiter(',')
    ->capture_default_str();
  app.add_option("--radii", o.radii, "Radii in mean edge lengths")->delimiter(',')->capture_default_str();
  app.add_option("--vertices", o.vertices, "About as many per mesh")->capture_default_str();
  app.add_option("--seeds", o.seeds, "How many meshes of each kind, which differ in what is random")
    ->capture_default_str();
  app.add_flag("--gaussian", o.gaussian, "Gaussian noise of the same standard deviation instead of uniform noise");
  app.add_option("--outliers", o.outliers, "Share of vertices that are moved by three mean edge lengths")
    ->capture_default_str();
}

// what --quick sets where nothing else was asked for
void be_quick(const CLI::App& app, Options& o)
{
  const auto set = [&](const char* option, auto& value, const auto& quick) {
    if(app.count(option) == 0)
      value = quick;
  };
  set("--shapes", o.shapes, std::vector<std::string>{"torus", "saddle"});
  set("--noise", o.noise, std::vector<double>{0, 1});
  set("--radii", o.radii, std::vector<double>{2, 4});
  set("--vertices", o.vertices, std::size_t(2500));
}

class Comparison
{
public:
  Comparison(const Options& options, std::string command_line)
    : options(options), estimators(select_estimators(options.estimators)), results("accuracy", std::move(command_line)),
      averages(names(estimators), options.tessellations)
  {
    results.describe(estimators);
  }

  void run()
  {
    Progress progress(number_of_runs(), options.no_progress);
    for(const auto& shape : options.shapes)
      for(const auto& tessellation : options.tessellations)
        for(std::size_t seed = 1; seed <= options.seeds; ++seed)
          for(const double noise : options.noise)
          {
            const Recipe recipe = make_recipe(shape, tessellation, noise, seed);
            const Surface surface = make_surface(recipe);
            for(const auto& estimator : estimators)
              for(const double radius : radii_of(*estimator))
              {
                measure(*estimator, radius, recipe, tessellation, surface);
                progress.step();
              }
          }
  }

  void report() const
  {
    averages.print(std::cout);
    if(!options.output.empty())
      results.write(options.output);
  }

private:
  static std::vector<std::string> names(const Estimators& estimators)
  {
    std::vector<std::string> result;
    for(const auto& estimator : estimators)
      result.push_back(estimator->name());
    return result;
  }

  // in mean edge lengths; estimators without radius are run once, and count the vertices that those of the smallest do
  std::vector<double> radii_of(const Estimator& estimator) const
  {
    if(estimator.uses_radius())
      return options.radii;
    return {*std::min_element(options.radii.begin(), options.radii.end())};
  }

  std::size_t number_of_runs() const
  {
    std::size_t per_surface = 0;
    for(const auto& estimator : estimators)
      per_surface += radii_of(*estimator).size();
    return per_surface * options.shapes.size() * options.tessellations.size() * options.seeds * options.noise.size();
  }

  Recipe make_recipe(const std::string& shape, const std::string& tessellation, double noise, std::size_t seed) const
  {
    Recipe recipe;
    recipe.shape = shape;
    recipe.tessellation = tessellation_of(tessellation);
    recipe.number_of_vertices = options.vertices;
    recipe.noise.amplitude = noise;
    recipe.noise.outlier_share = options.outliers;
    if(options.gaussian)
      recipe.noise.distribution = Noise::Distribution::gaussian;
    recipe.seed = seed;
    return recipe;
  }

  void measure(const Estimator& estimator, double radius, const Recipe& recipe, const std::string& tessellation,
               const Surface& surface)
  {
    const double length = radius * surface.mean_edge_length;
    const Timed_estimates timed = CGAL::Spider::benchmark::run(estimator, surface.mesh, length);
    const double microseconds = 1e6 * timed.seconds / surface.mesh.number_of_vertices();
    const Errors errors =
      compare(timed.estimates, surface.truth, interior_vertices(surface, length), surface.rms_curvature);

    const double shown_radius = estimator.uses_radius() ? radius : 0;
    averages.add(recipe.noise.amplitude, shown_radius, estimator.name(), tessellation, errors, microseconds);
    const Row setting = {{"estimator", estimator.name()},
                         {"shape", recipe.shape},
                         {"tessellation", tessellation},
                         {"mesh_vertices", surface.mesh.number_of_vertices()},
                         {"noise", recipe.noise.amplitude},
                         {"distribution", options.gaussian ? "gaussian" : "uniform"},
                         {"outliers", recipe.noise.outlier_share},
                         {"seed", recipe.seed},
                         {"radius", shown_radius}};
    Row row = setting;
    append(row, errors);
    row["microseconds"] = microseconds;
    results.add("errors", std::move(row));
    add_border_rows(setting, compare_by_border_distance(timed.estimates, surface, length));
  }

  void add_border_rows(const Row& setting, const std::vector<Errors>& bins)
  {
    for(std::size_t i = 0; i < bins.size(); ++i)
    {
      Row row = setting;
      row["distance"] = border_bins[i];
      append(row, bins[i]);
      results.add("border", std::move(row));
    }
  }

  Options options;
  Estimators estimators;
  Results results;
  Averages averages;
};

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Compares curvature estimators on surfaces whose curvature is known.");
  Options options;
  read_options(app, options);
  CLI11_PARSE(app, argc, argv);
  if(options.quick)
    be_quick(app, options);
  if(options.shapes == std::vector<std::string>{"all"})
    options.shapes = shape_names();

  return report_errors([&] {
    Comparison comparison(options, command_line(argc, argv));
    comparison.run();
    comparison.report();
  });
}
