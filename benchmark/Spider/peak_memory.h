// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_PEAK_MEMORY_H
#define CGAL_SPIDER_BENCHMARK_PEAK_MEMORY_H

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Spider {
namespace benchmark {

// The bytes by which the process' memory grows at most while `work` runs, whoever allocates them. It runs in a child of
// this process, so that what ran before doesn't count, and its effects are lost. Linux; std::runtime_error if it fails.
std::size_t peak_memory(const std::function<void()>& work);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_PEAK_MEMORY_H
