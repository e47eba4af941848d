// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "noise.h"

#include <cmath>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

double displacement(const Noise& noise, Random& random)
{
  // every number is drawn whether needed or not: vertices that are no outliers move alike with and without outliers
  const double outlier = random.uniform(), side = random.uniform();
  const double moved =
    noise.distribution == Noise::Distribution::uniform ? random.uniform() - 0.5 : random.gaussian() / std::sqrt(12.);
  if(outlier < noise.outlier_share)
    return side < 0.5 ? -noise.outlier_distance : noise.outlier_distance;
  return noise.amplitude * moved;
}

} // namespace

void add_noise(Mesh& mesh, const std::vector<Vector>& normals, double mean_edge_length, const Noise& noise,
               Random& random)
{
  for(auto v : mesh.vertices())
    mesh.point(v) += displacement(noise, random) * mean_edge_length * normals[v];
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
