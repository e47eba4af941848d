// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_MESH_IMPLICIT_H
#define CGAL_SPIDER_BENCHMARK_MESH_IMPLICIT_H

#include "Estimator.h"

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Spider {
namespace benchmark {

// The zero set of a function that is negative at the origin, by CGAL's Surface_mesher, within a few percent of the
// number of vertices. The surface must lie within the ball of radius 1.5. Large meshes are meshed coarsely and refined,
// so that the time stays linear. Vertices are near the surface, not on it: the caller projects them.
Mesh mesh_implicit(const std::function<double(const Point&)>& function, std::size_t number_of_vertices);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_MESH_IMPLICIT_H
