// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_STATISTICS_H
#define CGAL_SPIDER_TOOL_STATISTICS_H

#include <cmath> // before Boost's header, which needs it in its version 1.74 without including it

#include <boost/math/statistics/bivariate_statistics.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// returns the numbers among the values, ascending.
inline std::vector<double> sorted_numbers(std::vector<double> values)
{
  values.erase(std::remove_if(values.begin(), values.end(), [](double x) { return std::isnan(x); }), values.end());
  std::sort(values.begin(), values.end());
  return values;
}

// returns the value below which the share of the values lies, NaN where there are none.
inline double quantile(const std::vector<double>& sorted, double share)
{
  if(sorted.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const double position = share * static_cast<double>(sorted.size() - 1);
  const std::size_t below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

// How far two estimates of one quantity agree, over the places where both give a number.
struct Agreement
{
  double median_difference;
  double large_difference; // the 95th percentile: the worst of all says more about single places than about the methods
  double correlation;
};

inline Agreement agreement(const std::vector<double>& first, const std::vector<double>& second)
{
  std::vector<double> a, b, difference;
  for(std::size_t i = 0; i < first.size(); ++i)
    if(!std::isnan(first[i]) && !std::isnan(second[i]))
    {
      a.push_back(first[i]);
      b.push_back(second[i]);
      difference.push_back(std::abs(first[i] - second[i]));
    }
  difference = sorted_numbers(std::move(difference));
  const double correlation =
    a.size() < 2 ? std::numeric_limits<double>::quiet_NaN() : boost::math::statistics::correlation_coefficient(a, b);
  return {quantile(difference, 0.5), quantile(difference, 0.95), correlation};
}

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_STATISTICS_H
