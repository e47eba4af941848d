// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_MESH_TYPES_H
#define CGAL_SPIDER_BENCHMARK_MESH_TYPES_H

#include "Estimator.h"

#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

struct Spider_settings
{
  double radius;
  int directions; // 0 for the library's default
  int threads;    // more than one take TBB, else std::runtime_error
};

// Runs Spider at all vertices of a mesh, and returns the sum of the mean curvatures that it found. No more of that is
// kept, so that neither time nor memory is the results'.
using Spider_run = std::function<double(const Spider_settings&)>;

// A type of meshes that Spider takes.
struct Mesh_type
{
  std::string name;                                      // with the type of its numbers: Surface_mesh<float>
  std::function<Spider_run(const Mesh&)> run_on_copy_of; // the copy lives as long as what is returned
};

std::vector<Mesh_type> all_mesh_types();

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_MESH_TYPES_H
