// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_GRIDS_H
#define CGAL_SPIDER_BENCHMARK_GRIDS_H

#include "Estimator.h"

#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {
namespace Spider {
namespace benchmark {

// One coordinate of a grid: how many vertices it has, and whether the last is followed by the first again.
struct Axis
{
  std::size_t count;
  bool closed;
};

// The grid over [0, 1]^2, each cell cut along the same diagonal; `position` maps (s, t) to the surface, and the faces
// show the side of the cross product of its derivatives by s and by t.
Mesh make_grid(const std::pair<Axis, Axis>& axes, const std::function<Point(double, double)>& position);

// `mesh` with every edge cut into `pieces` equal ones and every face into their square, all flat.
Mesh refine(const Mesh& mesh, unsigned int pieces);

// The icosahedron refined and blown up to the unit sphere: 10 pieces^2 + 2 vertices, as near as can be to the number.
Mesh make_icosphere(std::size_t number_of_vertices);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_GRIDS_H
