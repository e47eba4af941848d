// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "summary.h"

#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <string>

namespace CGAL {
namespace Spider {
namespace demo {

namespace {

constexpr int label_width = 24;
constexpr int column_width = 16;
constexpr int digits = 4; // of numbers that are statistics of estimates

template <typename First, typename Second>
void print_row(std::ostream& out, const std::string& label, const First& spider, const Second& jets)
{
  out << std::left << std::setw(label_width) << label << std::right << std::setprecision(digits)
      << std::setw(column_width) << spider << std::setw(column_width) << jets << '\n';
}

template <typename Answer, typename Measure>
std::vector<double> values(const std::vector<Answer>& answers, const Measure& measure)
{
  std::vector<double> result;
  std::transform(answers.begin(), answers.end(), std::back_inserter(result), measure);
  return result;
}

constexpr auto mean_curvature = [](const auto& answer) { return answer.mean_curvature(); };
constexpr auto Gaussian_curvature = [](const auto& answer) { return answer.Gaussian_curvature(); };

void print_time(std::ostream& out, const Run<Estimate>& spider, const Run<Jet_estimate>& jets)
{
  const double microseconds_per_second = 1e6;
  const auto per_vertex = [&](const auto& run) { return microseconds_per_second * run.seconds / run.answers.size(); };
  print_row(out, "time, s", spider.seconds, jets.seconds);
  print_row(out, "  per vertex, us", per_vertex(spider), per_vertex(jets));
  print_row(out, "  ratio", spider.seconds / jets.seconds, 1);
}

void print_statuses(std::ostream& out, const Run<Estimate>& spider, const Run<Jet_estimate>& jets)
{
  const auto jets_given = std::count_if(jets.answers.begin(), jets.answers.end(),
                                        [](const Jet_estimate& e) { return !std::isnan(e.mean_curvature()); });
  const auto number_of = [&](Estimate_status status) {
    return std::count_if(spider.answers.begin(), spider.answers.end(),
                         [&](const Estimate& e) { return e.status == status; });
  };
  print_row(out, "vertices ok", number_of(ok), jets_given);
  print_row(out, "  partial", number_of(partial), "-");
  print_row(out, "  insufficient", number_of(insufficient), jets.answers.size() - jets_given - number_of(isolated));
  print_row(out, "  isolated", number_of(isolated), number_of(isolated));
}

void print_distribution(std::ostream& out, const std::string& name, const std::vector<double>& spider,
                        const std::vector<double>& jets)
{
  const std::vector<double> spider_sorted = sorted_numbers(spider), jets_sorted = sorted_numbers(jets);
  std::string label = name;
  for(double share : {0.05, 0.25, 0.5, 0.75, 0.95})
  {
    label.resize(12, ' ');
    print_row(out, label + std::to_string(std::lround(100 * share)) + " %", quantile(spider_sorted, share),
              quantile(jets_sorted, share));
    label.clear();
  }
}

// of the jets, so that the unit in which Spider's difference from them is told isn't Spider's own
double root_mean_square_curvature(const std::vector<Jet_estimate>& jets)
{
  double sum = 0;
  std::size_t count = 0;
  for(const Jet_estimate& e : jets)
    if(!std::isnan(e.mean_curvature()))
    {
      sum += (e.min_curvature * e.min_curvature + e.max_curvature * e.max_curvature) / 2;
      ++count;
    }
  return std::sqrt(sum / count);
}

void print_agreement(std::ostream& out, const Agreement& in_H, double rms)
{
  if(std::isnan(in_H.median_difference))
  {
    out << "\nNo vertex has an answer of both, so there is nothing to compare.\n";
    return;
  }
  out << "\nH of the two differs by " << in_H.median_difference / rms << " (median) and " << in_H.large_difference / rms
      << " (95th percentile)\nof the root mean square curvature, " << rms << "; their correlation is "
      << in_H.correlation << ".\n";
}

} // namespace

void print_summary(std::ostream& out, const Run<Estimate>& spider, const Run<Jet_estimate>& jets)
{
  const std::vector<double> spider_H = values(spider.answers, mean_curvature);
  const std::vector<double> jets_H = values(jets.answers, mean_curvature);

  print_row(out, "", "Spider", "jets, d = 2");
  print_time(out, spider, jets);
  print_statuses(out, spider, jets);
  print_distribution(out, "H", spider_H, jets_H);
  print_distribution(out, "K", values(spider.answers, Gaussian_curvature), values(jets.answers, Gaussian_curvature));

  print_agreement(out, agreement(spider_H, jets_H), root_mean_square_curvature(jets.answers));
}

} // namespace demo
} // namespace Spider
} // namespace CGAL
