// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_SUMMARY_H
#define CGAL_SPIDER_TOOL_SUMMARY_H

#include "statistics.h"
#include "tool_types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

inline constexpr std::array<double, 5> shown_quantiles = {0.05, 0.25, 0.5, 0.75, 0.95};

// What is told of one run: how long it took, vertices by status, and how H and K are distributed.
struct Summary
{
  std::string title;
  double seconds;
  std::size_t vertices;
  std::array<std::size_t, isolated + 1> by_status;
  std::array<double, shown_quantiles.size()> H, K; // at shown_quantiles

  double microseconds_per_vertex() const { return 1e6 * seconds / static_cast<double>(vertices); }
};

template <typename Answer, typename Measure>
std::vector<double> values(const std::vector<Answer>& answers, const Measure& measure)
{
  std::vector<double> result;
  std::transform(answers.begin(), answers.end(), std::back_inserter(result), measure);
  return result;
}

inline constexpr auto mean_curvature = [](const auto& answer) { return answer.mean_curvature(); };
inline constexpr auto Gaussian_curvature = [](const auto& answer) { return answer.Gaussian_curvature(); };

inline std::array<double, shown_quantiles.size()> quantiles(std::vector<double> numbers)
{
  const std::vector<double> sorted = sorted_numbers(std::move(numbers));
  std::array<double, shown_quantiles.size()> result;
  std::transform(shown_quantiles.begin(), shown_quantiles.end(), result.begin(),
                 [&](double share) { return quantile(sorted, share); });
  return result;
}

// `status_of` tells the status of an answer.
template <typename Answer, typename StatusOf>
Summary summarise(const std::string& title, const Run<Answer>& run, const StatusOf& status_of)
{
  Summary summary{title,
                  run.seconds,
                  run.answers.size(),
                  {},
                  quantiles(values(run.answers, mean_curvature)),
                  quantiles(values(run.answers, Gaussian_curvature))};
  for(const Answer& answer : run.answers)
    ++summary.by_status[status_of(answer)];
  return summary;
}

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_SUMMARY_H
