// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How wrong the estimators are on surfaces whose curvature is known.

#include "Averages.h"
#include "Results.h"
#include "options.h"
#include "registry.h"
#include "stability.h"

#include <algorithm>
#include <cmath>

using namespace CGAL::Spider::benchmark;

namespace {

struct Options : Estimator_options
{
  std::vector<std::string> shapes = {"sphere", "torus", "ellipsoid", "saddle", "waves"};
  std::vector<std::string> tessellations = tessellation_names();
  std::vector<double> noise = {0, 0.25, 0.5, 1};
  std::vector<double> radii = {2, 4, 8};
  std::size_t vertices = 10000;
  std::size_t seeds = 1;
  bool gaussian = false;
  double outliers = 0;
  bool stability = false;
  bool pictures = false;
};

void read_options(CLI::App& app, Options& o)
{
  o.add_to(app);
  add_list(app, "--shapes", o.shapes,
           "Of sphere, torus, ellipsoid, saddle, waves, cylinder, monkey_saddle, implicit; or all");
  add_list(app, "--tessellations", o.tessellations, "Of regular, irregular, slivers");
  add_list(app, "--noise", o.noise, "Amplitudes in mean edge lengths; 1 is the paper's");
  add_list(app, "--radii", o.radii, "Radii in mean edge lengths");
  app.add_option("--vertices", o.vertices, "About as many per mesh")->capture_default_str();
  app.add_option("--seeds", o.seeds, "How many meshes of each kind, which differ in what is random")
    ->capture_default_str();
  app.add_flag("--gaussian", o.gaussian, "Gaussian noise of the same standard deviation instead of uniform noise");
  app.add_option("--outliers", o.outliers, "Share of vertices that are moved by three mean edge lengths")
    ->capture_default_str();
  app.add_flag("--stability", o.stability,
               "Also how much answers change at the last radius where the noisiest surfaces are cut otherwise");
  app.add_flag("--pictures", o.pictures, "Also write the noisiest surfaces with H at the last radius, for the report");
}

// what --quick sets where nothing else was asked for
void be_quick(const CLI::App& app, Options& o)
{
  const auto set = [&](const char* option, auto& value, const auto& quick) {
    if(app.count(option) == 0)
      value = quick;
  };
  set("--shapes", o.shapes, std::vector<std::string>{"torus", "saddle"});
  set("--tessellations", o.tessellations, std::vector<std::string>{"irregular", "slivers"});
  set("--noise", o.noise, std::vector<double>{0, 1});
  set("--radii", o.radii, std::vector<double>{2, 4});
  set("--vertices", o.vertices, std::size_t(2000)); // on fewer, the larger radius is that of the torus' tube
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
            compare_on(make_recipe(shape, tessellation, noise, seed), tessellation, progress);
  }

  void report() const
  {
    averages.print(std::cout);
    if(!options.output.empty())
      results.write(options.output);
  }

private:
  using Triangulations = std::vector<std::pair<std::string, Mesh>>;

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

  // Surfaces of the first seed with the most noise stand for the others where looking at all would take long.
  bool is_showpiece(const Recipe& recipe) const
  {
    return recipe.seed == 1 && recipe.noise.amplitude == *std::max_element(options.noise.begin(), options.noise.end());
  }

  void compare_on(const Recipe& recipe, const std::string& tessellation, Progress& progress)
  {
    const Surface surface = make_surface(recipe);
    Triangulations others;
    if(options.stability && is_showpiece(recipe))
      others = other_triangulations(surface.mesh);
    Row picture = picture_of(recipe, tessellation, surface);
    for(const auto& estimator : estimators)
      for(const double radius : radii_of(*estimator))
      {
        const Row setting = setting_of(*estimator, radius, recipe, tessellation, surface);
        const auto estimates = measure(*estimator, radius, setting, surface);
        if(radius == radii_of(*estimator).back())
          for(const auto& other : others)
            add_change(*estimator, radius, setting, surface, estimates, other);
        picture["fields"][estimator->name()] = mean_curvatures(estimates); // the last radius stays
        progress.step();
      }
    if(options.pictures && is_showpiece(recipe))
      results.add("pictures", std::move(picture));
  }

  Row setting_of(const Estimator& estimator, double radius, const Recipe& recipe, const std::string& tessellation,
                 const Surface& surface) const
  {
    return {{"estimator", estimator.name()},
            {"shape", recipe.shape},
            {"tessellation", tessellation},
            {"mesh_vertices", surface.mesh.number_of_vertices()},
            {"noise", recipe.noise.amplitude},
            {"distribution", options.gaussian ? "gaussian" : "uniform"},
            {"outliers", recipe.noise.outlier_share},
            {"seed", recipe.seed},
            {"radius", estimator.uses_radius() ? radius : 0}};
  }

  std::vector<Estimate> measure(const Estimator& estimator, double radius, const Row& setting, const Surface& surface)
  {
    const double length = radius * surface.mean_edge_length;
    const Timed_estimates timed = CGAL::Spider::benchmark::run(estimator, surface.mesh, length);
    const double microseconds = 1e6 * timed.seconds / static_cast<double>(surface.mesh.number_of_vertices());
    const Errors errors =
      compare(timed.estimates, surface.truth, interior_vertices(surface, length), surface.rms_curvature);

    averages.add(setting["noise"], setting["radius"], estimator.name(), setting["tessellation"], errors, microseconds);
    Row row = setting;
    append(row, errors);
    row["microseconds"] = microseconds;
    results.add("errors", std::move(row));
    add_border_rows(setting, compare_by_border_distance(timed.estimates, surface, length));
    return timed.estimates;
  }

  void add_change(const Estimator& estimator, double radius, Row row, const Surface& surface,
                  const std::vector<Estimate>& estimates, const Triangulations::value_type& other)
  {
    const double length = radius * surface.mean_edge_length;
    const auto there = CGAL::Spider::benchmark::run(estimator, other.second, length).estimates;
    const Errors change = compare(transfer(other.second, there, surface.mesh), estimates,
                                  interior_vertices(surface, length), surface.rms_curvature);
    row["change"] = other.first;
    append(row, change);
    results.add("stability", std::move(row));
  }

  static Row mean_curvatures(const std::vector<Estimate>& estimates)
  {
    Row field = Row::array();
    for(const Estimate& e : estimates)
      field.push_back(std::isfinite(e.mean_curvature()) ? Row(e.mean_curvature()) : Row(nullptr));
    return field;
  }

  Row picture_of(const Recipe& recipe, const std::string& tessellation, const Surface& surface) const
  {
    Row points = Row::array(), faces = Row::array();
    for(const Point& p : surface.mesh.points())
      points.push_back({p.x(), p.y(), p.z()});
    for(auto face : surface.mesh.faces())
    {
      Row corners = Row::array();
      for(auto v : surface.mesh.vertices_around_face(surface.mesh.halfedge(face)))
        corners.push_back(v.idx());
      faces.push_back(std::move(corners));
    }
    return {{"shape", recipe.shape},
            {"tessellation", tessellation},
            {"noise", recipe.noise.amplitude},
            {"radius", options.radii.back()},
            {"points", std::move(points)},
            {"faces", std::move(faces)},
            {"fields", {{"truth", mean_curvatures(surface.truth)}}}};
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
