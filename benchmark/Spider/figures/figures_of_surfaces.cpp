// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures 5 and 6: surfaces whose curvature is known, under noise and in a bad tessellation.

#include "../Surface.h"
#include "../estimators/Meyer_2003.h"
#include "Figure.h"
#include "figure_estimates.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

std::vector<Estimate> estimate_by(const Estimator& estimator, const Mesh& mesh)
{
  constexpr double no_radius = 0; // of one-ring estimators
  std::vector<Estimate> estimates;
  estimator.estimate(mesh, no_radius, estimates);
  return estimates;
}

// Since H passes through zero on a saddle, errors are related to its mean magnitude, not to the vertex' own H.
template <typename Estimates>
double mean_relative_error(const Surface& surface, const Estimates& estimates, double margin)
{
  double errors = 0, magnitudes = 0;
  for(auto v : surface.mesh.vertices())
    if(surface.border_distance[v] > margin && !std::isnan(estimates[v].mean_curvature()))
    {
      errors += std::abs(estimates[v].mean_curvature() - surface.truth[v].mean_curvature());
      magnitudes += std::abs(surface.truth[v].mean_curvature());
    }
  return errors / magnitudes;
}

} // namespace

Figure figure_5(const Figure_input&)
{
  constexpr int seeds = 5;
  constexpr double most = 6, step = 0.5; // the paper's radii are from 1 to 3
  constexpr double last_of_the_paper = 3;
  Recipe recipe;
  recipe.number_of_vertices = 2500;
  recipe.noise.amplitude = 1;

  std::vector<double> radii, published, ours;
  for(double r = 1; r <= most; r += step)
    radii.push_back(r);
  published.assign(radii.size(), 0);
  ours.assign(radii.size(), 0);
  double meyer = 0;
  Figure figure(5, "Error of H against the radius on a noisy saddle");
  for(int seed = 1; seed <= seeds; ++seed)
  {
    recipe.seed = seed;
    const Surface surface = make_surface(recipe);
    const double a = surface.mean_edge_length, margin = most * a;
    meyer +=
      mean_relative_error(surface, estimate_by(Meyer_2003(Meyer_2003::Smoothing::none), surface.mesh), margin) / seeds;
    for(std::size_t i = 0; i < radii.size(); ++i)
    {
      published[i] += mean_relative_error(surface, estimate_as_published(surface.mesh, radii[i] * a), margin) / seeds;
      ours[i] += mean_relative_error(surface, estimate(surface.mesh, radii[i] * a), margin) / seeds;
    }
    if(seed == 1)
    {
      figure.add_mesh("mesh", surface.mesh);
      figure.add_panel("noise in [\u2212a/2, a/2]", "mesh");
    }
  }
  figure.add_curve("Meyer et al. 2003", radii, std::vector<double>(radii.size(), meyer));
  figure.add_curve("section_fit, as published", radii, published);
  figure.add_curve("surface_fit, the default", radii, ours);

  const std::size_t last = std::find(radii.begin(), radii.end(), last_of_the_paper) - radii.begin();
  const auto falls = [](const std::vector<double>& errors) { return std::is_sorted(errors.rbegin(), errors.rend()); };
  const auto curve = [&](const std::vector<double>& errors) {
    std::string text;
    for(double r : {1., 2., 3., 6.})
      text += (text.empty() ? "" : ", ") + digits(errors[std::find(radii.begin(), radii.end(), r) - radii.begin()]) +
              " at " + digits(r) + " a";
    return text;
  };
  figure.add_number("mean relative error of H by Meyer et al.", digits(meyer));
  figure.add_claim("mean relative error of H, as published", "decreases with the radius", curve(published),
                   falls(published));
  const auto below = std::find_if(published.begin(), published.end(), [&](double error) { return error < meyer; });
  figure.add_number("the first of the radii at which that is less than Meyer's",
                    below == published.end() ? "none" : digits(radii[below - published.begin()]) + " a");
  figure.add_claim("the same against Meyer's at r = 3 a", "less", digits(published[last] / meyer) + " of it",
                   published[last] < meyer);
  figure.add_claim("mean relative error of H, surface_fit", "decreases with the radius", curve(ours), falls(ours));
  figure.add_claim("the same against Meyer's at r = 3 a", "less", digits(ours[last] / meyer) + " of it",
                   ours[last] < meyer);
  return figure;
}

Figure figure_6(const Figure_input&)
{
  Recipe recipe;
  recipe.shape = "waves";
  recipe.tessellation = Tessellation::slivers;
  recipe.number_of_vertices = 4000;
  const Surface surface = make_surface(recipe);
  const double a = surface.mean_edge_length, margin = 2 * a;

  const auto meyer = estimate_by(Meyer_2003(Meyer_2003::Smoothing::none), surface.mesh);
  const auto smoothed = estimate_by(Meyer_2003(Meyer_2003::Smoothing::laplacian), surface.mesh);
  const auto published = estimate_as_published(surface.mesh, a);
  const auto ours = estimate(surface.mesh, a);

  Figure figure(6, "Mean curvature in a bad tessellation");
  figure.add_mesh("mesh", surface.mesh);
  figure.add_panel("the mesh", "mesh");
  const auto add = [&](const std::string& title, const std::vector<double>& field) {
    figure.add_panel(title, "mesh");
    figure.add_field("H", field);
  };
  add("Meyer et al. 2003", mean_curvatures(meyer));
  add("the same, smoothed", mean_curvatures(smoothed));
  add("Spider, r = a", mean_curvatures(ours));

  const double of_meyer = mean_relative_error(surface, meyer, margin);
  const double of_smoothed = mean_relative_error(surface, smoothed, margin);
  const double of_published = mean_relative_error(surface, published, margin);
  const double of_ours = mean_relative_error(surface, ours, margin);
  figure.add_number("mean relative error of H by Meyer et al., and smoothed in 10 rounds of factor 0.2",
                    digits(of_meyer) + ", " + digits(of_smoothed));
  const auto add_claim = [&](const std::string& name, double error) {
    figure.add_claim("mean relative error of H by " + name + ", r = a", "less than both", digits(error),
                     error < std::min(of_meyer, of_smoothed));
  };
  add_claim("section_fit as published", of_published);
  add_claim("surface_fit", of_ours);
  return figure;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
