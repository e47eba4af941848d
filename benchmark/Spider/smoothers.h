// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_SMOOTHERS_H
#define CGAL_SPIDER_BENCHMARK_SMOOTHERS_H

#include "Estimator.h"

#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

// One way to smooth a mesh.
struct Smoother
{
  std::string name;              // short and unique
  std::string settings;          // one line for the report, with what its strength is
  std::vector<double> strengths; // that it is tried at, to find its best
  std::function<void(Mesh& mesh, double strength, int rounds)> smooth;
};

std::vector<Smoother> all_smoothers();

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_SMOOTHERS_H
