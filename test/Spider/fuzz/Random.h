// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_FUZZ_RANDOM_H
#define CGAL_SPIDER_FUZZ_RANDOM_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace fuzz {

/// Numbers that a seed determines with every standard library, whose distributions would differ.
class Random
{
public:
  Random(std::uint64_t seed, std::uint64_t case_number)
  {
    std::seed_seq sequence{seed, seed >> 32, case_number, case_number >> 32};
    engine_.seed(sequence);
  }

  /// returns a whole number from 0 to `count` - 1.
  std::size_t below(std::size_t count) { return engine_() % count; }
  int between(int least, int most)
  {
    return least + static_cast<int>(below(static_cast<std::size_t>(most - least) + 1));
  }
  bool one_in(std::size_t count) { return below(count) == 0; }
  double real(double least, double most)
  {
    return least + (most - least) * (static_cast<double>(engine_()) / 4294967295.);
  }
  double power_of_ten(double least, double most) { return std::pow(10, real(least, most)); }

  template <typename Range>
  const auto& one_of(const Range& range)
  {
    return *(std::begin(range) + static_cast<std::ptrdiff_t>(below(std::size(range))));
  }

private:
  std::mt19937 engine_;
};

} // namespace fuzz

#endif // CGAL_SPIDER_FUZZ_RANDOM_H
