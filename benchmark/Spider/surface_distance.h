// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_SURFACE_DISTANCE_H
#define CGAL_SPIDER_BENCHMARK_SURFACE_DISTANCE_H

#include "Estimator.h"

namespace CGAL {
namespace Spider {
namespace benchmark {

// How far two surfaces are from each other, each from the other: vertices may slide along a surface at no cost.
struct Surface_distance
{
  double mean;     // over the area of each
  double greatest; // the Hausdorff distance
};

// Measured at the vertices, and at three points of each face.
Surface_distance surface_distance(const Mesh& a, const Mesh& b);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_SURFACE_DISTANCE_H
