// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Work whose cost is the same at every run: valgrind counts the instructions of `spider_measured()`, and this program
// itself counts the bytes. check_costs.cmake compares with what is allowed.

#include "meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

#include <malloc.h>

namespace {

std::size_t bytes = 0, peak_of_bytes = 0;

} // namespace

// Everything large is in vectors, so this counts all that matters. Inlined, g++ takes the pair for a mismatch.
__attribute__((noinline)) void* operator new(std::size_t size)
{
  void* const place = std::malloc(size);
  if(place == nullptr)
    throw std::bad_alloc();
  bytes += malloc_usable_size(place);
  peak_of_bytes = std::max(peak_of_bytes, bytes);
  return place;
}

__attribute__((noinline)) void operator delete(void* place) noexcept
{
  bytes -= malloc_usable_size(place);
  std::free(place);
}

void operator delete(void* place, std::size_t) noexcept { operator delete(place); }

extern "C" __attribute__((noinline)) void spider_measured(const std::function<void()>& work) { work(); }

namespace {

namespace Spider = CGAL::Spider;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr int level = 6;
constexpr double length_of_edges(int level) { return 1.1 / (1 << level); }
constexpr double edge_length = length_of_edges(level);

/// returns a sphere with 10 * 4^level + 2 vertices, and noise of a quarter of the edges' length.
Mesh noisy_sphere(int level) { return meshes::jittered(meshes::icosphere<Mesh>(level), length_of_edges(level) / 4, 1); }

template <typename NamedParameters>
void estimate_some(const Mesh& mesh, std::size_t count, const NamedParameters& np)
{
  const Spider::Curvature_estimator estimator(mesh, np);
  const auto vertices = estimator.vertices_in_spatial_order();
  auto worker = estimator.worker();
  spider_measured([&] {
    for(std::size_t i = 0; i < count; ++i)
      worker(vertices[i]);
  });
}

/// does some work, and returns the number of vertices that it is for.
std::size_t run(const std::string& work)
{
  constexpr std::size_t count = 1000;
  const Mesh mesh = noisy_sphere(level);
  if(work == "preparation")
    spider_measured([&] { Spider::Curvature_estimator(mesh, Spider::parameters::geodesic_radius(4 * edge_length)); });
  else if(work == "default_4_edges")
    estimate_some(mesh, count, Spider::parameters::geodesic_radius(4 * edge_length));
  else if(work == "16_directions_4_edges")
    estimate_some(mesh, count, Spider::parameters::geodesic_radius(4 * edge_length).number_of_directions(16));
  else if(work == "16_directions_16_edges")
    estimate_some(mesh, count, Spider::parameters::geodesic_radius(16 * edge_length).number_of_directions(16));
  else
    throw std::invalid_argument("there is no work called " + work);
  return work == "preparation" ? mesh.number_of_vertices() : count;
}

/// returns the bytes per vertex that estimating at all vertices takes beyond the mesh and the results.
std::size_t bytes_per_vertex()
{
  constexpr int level = 7; // large enough for what doesn't grow with the mesh, a megabyte, to count for little
  Mesh mesh = noisy_sphere(level);
  auto curvature = mesh.add_property_map<Mesh::Vertex_index, Spider::Curvature_estimate_3<Kernel>>("v:curvature").first;
  const std::size_t before = peak_of_bytes = bytes;
  Spider::estimate_vertex_curvatures(mesh, curvature, Spider::parameters::geodesic_radius(length_of_edges(level)));
  return (peak_of_bytes - before) / mesh.number_of_vertices();
}

} // namespace

int main(int argc, char** argv)
{
  const std::string work = argc == 2 ? argv[1] : "";
  if(work == "bytes")
    std::cout << "bytes per vertex: " << bytes_per_vertex() << '\n';
  else
    std::cout << "vertices: " << run(work) << '\n';
}
