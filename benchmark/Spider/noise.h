// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_NOISE_H
#define CGAL_SPIDER_BENCHMARK_NOISE_H

#include "Estimator.h"
#include "Random.h"

#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

// What a scanner would add to a surface. Lengths are in units of the mean edge length of the mesh.
struct Noise
{
  enum class Distribution
  {
    uniform, // in [-amplitude / 2, amplitude / 2], as in the paper
    gaussian // with the standard deviation of that: amplitude / sqrt(12)
  };

  double amplitude = 0;
  Distribution distribution = Distribution::uniform;
  double outlier_share = 0;    // of the vertices, which are moved by
  double outlier_distance = 3; // to either side, and not by the noise
};

// Moves the vertices of a mesh along their unit normals.
void add_noise(Mesh& mesh, const std::vector<Vector>& normals, double mean_edge_length, const Noise& noise,
               Random& random);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_NOISE_H
