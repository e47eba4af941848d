// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "smoothers.h"
#include "tessellations.h"

#include <CGAL/Polygon_mesh_processing/angle_and_area_smoothing.h>
#include <CGAL/Polygon_mesh_processing/smooth_shape.h>
#include <CGAL/Spider/smooth_by_geodesic_rings.h>

#include <cmath>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

void smooth_by_laplacian(Mesh& mesh, double factor, int rounds)
{
  for(int round = 0; round < rounds; ++round)
  {
    const std::vector<Point> before(mesh.points().begin(), mesh.points().end());
    for(auto v : mesh.vertices())
    {
      if(mesh.is_isolated(v) || mesh.is_border(v))
        continue;
      Vector sum(0, 0, 0);
      for(auto w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
        sum += before[w] - before[v];
      mesh.point(v) = before[v] + factor / static_cast<double>(mesh.degree(v)) * sum;
    }
  }
}

// Lengths change with the square root of the time in this flow.
void smooth_by_mean_curvature_flow(Mesh& mesh, double time, int rounds)
{
  PMP::smooth_shape(mesh, time * std::pow(mean_edge_length(mesh), 2),
                    CGAL::parameters::number_of_iterations(static_cast<unsigned>(rounds)));
}

void smooth_by_rings(Mesh& mesh, double factor, int rounds)
{
  smooth_by_geodesic_rings(mesh, parameters::smoothing_factor(factor).number_of_iterations(rounds));
}

void smooth_by_rings_as_published(Mesh& mesh, double factor, int rounds)
{
  smooth_by_geodesic_rings(mesh, parameters::geodesic_radius(mean_edge_length(mesh) / 2)
                                   .smoothing_factor(factor)
                                   .keep_volume(false)
                                   .number_of_iterations(rounds));
}

void smooth_angles(Mesh& mesh, double, int rounds)
{
  PMP::angle_and_area_smoothing(mesh, CGAL::parameters::number_of_iterations(static_cast<unsigned>(rounds))
                                        .use_area_smoothing(false) // which takes Ceres
                                        .use_safety_constraints(false)
                                        .do_project(false));
}

} // namespace

std::vector<Smoother> all_smoothers()
{
  const std::vector<double> factors = {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5};
  const std::vector<double> times = {0.0003, 0.001, 0.002, 0.003, 0.005, 0.01, 0.03, 0.1};
  return {
    {"noisy", "as it was", {0}, [](Mesh&, double, int) {}},
    {"rings", "smooth_by_geodesic_rings(), defaults, the factor as well", {0.2}, smooth_by_rings},
    {"rings_as_published", "radius a/2, the volume not kept, by a factor", {0.2}, smooth_by_rings_as_published},
    {"laplacian", "towards the mean of the neighbours by a factor", factors, smooth_by_laplacian},
    {"smooth_shape", "PMP::smooth_shape(), by a time in units of a squared", times, smooth_by_mean_curvature_flow},
    {"angle_and_area", "PMP::angle_and_area_smoothing(), angles alone, without projection", {0}, smooth_angles},
  };
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
