// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_ESTIMATORS_SPIDER_H
#define CGAL_SPIDER_BENCHMARK_ESTIMATORS_SPIDER_H

#include "../Estimator.h"

namespace CGAL {
namespace Spider {
namespace benchmark {

// surface_fit, all else the library's defaults
std::unique_ptr<Estimator> spider(unsigned int degree);

// section_fit with the paper's settings
std::unique_ptr<Estimator> spider_as_published();

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_ESTIMATORS_SPIDER_H
