// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Figure 11: smoothing by geodesic rings beside Laplacian smoothing.

#include "../noise.h"
#include "../tessellations.h"
#include "Figure.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Spider/smooth_by_geodesic_rings.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

constexpr int rounds = 10; // the paper's, as the next is
constexpr double factor = 0.2;

Mesh laplacian(Mesh mesh)
{
  for(int round = 0; round < rounds; ++round)
  {
    const std::vector<Point> before(mesh.points().begin(), mesh.points().end());
    for(auto v : mesh.vertices())
    {
      Vector sum(0, 0, 0);
      for(auto w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
        sum += before[w] - before[v];
      mesh.point(v) = before[v] + factor / static_cast<double>(mesh.degree(v)) * sum;
    }
  }
  return mesh;
}

struct Distances
{
  double mean, greatest, volume; // the first two of the vertices to where they were, in edge lengths
};

Distances compare(const Mesh& mesh, const Mesh& clean)
{
  Distances distances = {0, 0,
                         CGAL::Polygon_mesh_processing::volume(mesh) / CGAL::Polygon_mesh_processing::volume(clean)};
  for(auto v : clean.vertices())
  {
    const double distance = std::sqrt(CGAL::squared_distance(mesh.point(v), clean.point(v)));
    distances.mean += distance / static_cast<double>(clean.number_of_vertices());
    distances.greatest = std::max(distances.greatest, distance);
  }
  const double a = mean_edge_length(clean);
  distances.mean /= a;
  distances.greatest /= a;
  return distances;
}

std::string describe(const Distances& d)
{
  return digits(d.mean) + " a on average, " + digits(d.greatest) + " a at most; volume " + (d.volume < 1 ? "" : "+") +
         digits(100 * (d.volume - 1)) + " %";
}

} // namespace

Figure figure_11(const Figure_input& input)
{
  const Mesh clean = input.mesh("elephant.off");
  Mesh noisy = clean;
  Random random(1);
  add_noise(noisy, area_weighted_normals(clean), mean_edge_length(clean), {1}, random);

  const Mesh smoothed = laplacian(noisy);
  Mesh by_rings = noisy, by_default = noisy;
  smooth_by_geodesic_rings(by_rings, parameters::geodesic_radius(mean_edge_length(noisy) / 2)
                                       .smoothing_factor(factor)
                                       .keep_volume(false)
                                       .number_of_iterations(rounds));
  smooth_by_geodesic_rings(by_default);

  Figure figure(11, "Smoothing by geodesic rings, and by the Laplacian");
  const auto add = [&](const std::string& title, const Mesh& mesh) {
    figure.add_mesh(title, mesh);
    figure.add_panel(title, title);
  };
  add("original", clean);
  add("with noise", noisy);
  add("Laplacian", smoothed);
  add("geodesic rings", by_rings);

  const Distances of_laplacian = compare(smoothed, clean), of_rings = compare(by_rings, clean);
  const Distances of_default = compare(by_default, clean);
  figure.add_number("vertices' distances from where they were: with noise", describe(compare(noisy, clean)));
  figure.add_number("after Laplacian smoothing", describe(of_laplacian));
  figure.add_claim("after smoothing by rings of radius a/2", "features are preserved that the Laplacian loses",
                   describe(of_rings), of_rings.mean < of_laplacian.mean && of_rings.greatest < of_laplacian.greatest);
  figure.add_claim("after smoothing by rings, Spider's defaults (radius by vertex, volume kept)",
                   "features are preserved that the Laplacian loses", describe(of_default),
                   of_default.mean < of_laplacian.mean && of_default.greatest < of_laplacian.greatest);
  return figure;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
