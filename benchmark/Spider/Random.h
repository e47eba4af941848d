// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_RANDOM_H
#define CGAL_SPIDER_BENCHMARK_RANDOM_H

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <cstdint>
#include <random>

namespace CGAL {
namespace Spider {
namespace benchmark {

// Random numbers that are the same everywhere: the standard fixes what std::mt19937_64 yields, but leaves open what
// its distributions make of that, so that these are our own.
class Random
{
public:
  explicit Random(std::uint64_t seed) : engine(seed) {}

  // in [0, 1), with all 53 bits of a double
  double uniform() { return static_cast<double>(engine() >> 11) * 0x1p-53; }

  double uniform(double from, double to) { return from + (to - from) * uniform(); }

  // mean 0, standard deviation 1 (Box and Muller; the second number is dropped so that calls don't depend on parity)
  double gaussian()
  {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(boost::math::constants::two_pi<double>() * uniform());
  }

private:
  std::mt19937_64 engine;
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_RANDOM_H
