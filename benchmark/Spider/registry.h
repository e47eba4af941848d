// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_REGISTRY_H
#define CGAL_SPIDER_BENCHMARK_REGISTRY_H

#include "Estimator.h"

#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

// The estimators whose names are among `names`; a name that is no estimator's own stands for all that contain it,
// letters' case aside. All of them for no names. std::invalid_argument, with the names that there are, for one that
// nothing matches.
Estimators select_estimators(const std::vector<std::string>& names);

struct Timed_estimates
{
  std::vector<Estimate> estimates;
  double seconds; // of processor time
};

// Runs one estimator. Processor time is taken, not the clock's, for others may be at work on the machine.
Timed_estimates run(const Estimator& estimator, const Mesh& mesh, double radius);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_REGISTRY_H
