// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_READ_MESH_H
#define CGAL_SPIDER_BENCHMARK_READ_MESH_H

#include "Estimator.h"

#include <string>

namespace CGAL {
namespace Spider {
namespace benchmark {

// Reads an OFF, OBJ, PLY or STL file, and splits faces that aren't triangles. std::runtime_error if that fails.
Mesh read_mesh(const std::string& path);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_READ_MESH_H
