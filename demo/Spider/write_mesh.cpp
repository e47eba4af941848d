// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_mesh.h"

#include "colour.h"
#include "statistics.h"

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cstdint>
#include <fstream>
#include <sstream>

namespace CGAL {
namespace Spider {
namespace demo {

namespace {

// adds a property to the vertices; CGAL writes it under its name without the "v:".
template <typename Value, typename Function>
void add_property(Mesh& mesh, const std::string& name, const std::vector<Estimate>& estimates, const Function& value)
{
  auto map = mesh.add_property_map<Vertex, Value>("v:" + name).first;
  for(Vertex v : mesh.vertices())
    map[v] = value(estimates[v]);
}

// adds a vector as three numbers, which is how PLY has vectors.
template <typename Function>
void add_vector_property(Mesh& mesh, const std::string& name, const std::vector<Estimate>& estimates,
                         const Function& value)
{
  for(int i = 0; i < 3; ++i)
    add_property<double>(mesh, name + "_" + "xyz"[i], estimates, [&](const Estimate& e) { return value(e)[i]; });
}

void add_estimates(Mesh& mesh, const std::vector<Estimate>& estimates)
{
  using E = Estimate;
  add_property<Kernel::Vector_3>(mesh, "normal", estimates, [](const E& e) { return e.normal; });
  add_property<double>(mesh, "k_min", estimates, [](const E& e) { return e.min_curvature; });
  add_property<double>(mesh, "k_max", estimates, [](const E& e) { return e.max_curvature; });
  add_property<double>(mesh, "H", estimates, [](const E& e) { return e.mean_curvature(); });
  add_property<double>(mesh, "K", estimates, [](const E& e) { return e.Gaussian_curvature(); });
  add_vector_property(mesh, "min_direction", estimates, [](const E& e) { return e.min_direction; });
  add_vector_property(mesh, "max_direction", estimates, [](const E& e) { return e.max_direction; });
  add_property<std::uint8_t>(mesh, "status", estimates, [](const E& e) { return std::uint8_t(e.status); });
  add_property<double>(mesh, "coverage", estimates, [](const E& e) { return e.coverage; });
  add_property<double>(mesh, "residual", estimates, [](const E& e) { return e.residual; });
}

// Sharp ridges, few as they are, must not leave the rest of the surface white.
double colour_limit(const std::vector<Estimate>& estimates)
{
  std::vector<double> magnitudes;
  for(const Estimate& estimate : estimates)
    magnitudes.push_back(std::abs(estimate.mean_curvature()));
  return quantile(sorted_numbers(std::move(magnitudes)), 0.9);
}

} // namespace

bool write_mesh(const std::string& file, Mesh mesh, const std::vector<Estimate>& estimates)
{
  const double limit = colour_limit(estimates);
  add_estimates(mesh, estimates);
  add_property<CGAL::IO::Color>(mesh, "color", estimates,
                                [&](const Estimate& e) { return diverging_colour(e.mean_curvature(), limit); });

  std::ostringstream comments;
  comments << "vertex colour: mean curvature H from " << -limit << " (blue) through 0 (white) to " << limit
           << " (red)\n"
           << "vertex status: " << int(ok) << " " << ok << ", " << int(partial) << " " << partial << ", "
           << int(insufficient) << " " << insufficient << ", " << int(isolated) << " " << isolated;
  std::ofstream out(file, std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  return out && CGAL::IO::write_PLY(out, mesh, comments.str()) && out.flush();
}

} // namespace demo
} // namespace Spider
} // namespace CGAL
