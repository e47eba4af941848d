// Copyright (c) 2026 The Spider authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_ESTIMATORS_H
#define CGAL_SPIDER_BENCHMARK_ESTIMATORS_H

#include "Estimator.h"

namespace CGAL {
namespace Spider {
namespace benchmark {

// All estimators under comparison, in the order in which tables list them. To add one: its header in estimators/,
// and its line here.
inline Estimators all_estimators()
{
  Estimators all;
  return all;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_ESTIMATORS_H
