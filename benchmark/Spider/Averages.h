// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_AVERAGES_H
#define CGAL_SPIDER_BENCHMARK_AVERAGES_H

#include "Results.h"

#include <iosfwd>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

// What compare_accuracy prints: the figures of each estimator, averaged over shapes and seeds, a block for each noise
// and radius, a column for each tessellation.
class Averages
{
public:
  Averages(std::vector<std::string> estimators, std::vector<std::string> tessellations);

  // `radius` is 0 where the estimator has none
  void add(double noise, double radius, const std::string& estimator, const std::string& tessellation,
           const Errors& errors, double microseconds);

  void print(std::ostream& out) const;

private:
  // of the figures that aren't NaN
  struct Average
  {
    double sum = 0;
    std::size_t count = 0;

    void add(double figure);
    double value() const;
  };

  // H, K, direction, wild and missing per thousand, microseconds
  static constexpr std::size_t figures = 5;
  using Cell = std::array<Average, figures>;

  std::vector<std::string> estimators, tessellations;
  std::map<std::pair<double, double>, std::map<std::pair<std::string, std::string>, Cell>> blocks;
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_AVERAGES_H
