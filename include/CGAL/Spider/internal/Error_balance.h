// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How wrong mean curvature is at each radius of a ladder, and at which radius it is least so: told from the answers
// alone, at a sample of vertices, without the truth. Each estimate comes with a standard error, which tells noise. What
// answers at successive radii differ by beyond that is bias of the larger one.

#ifndef CGAL_SPIDER_INTERNAL_ERROR_BALANCE_H
#define CGAL_SPIDER_INTERNAL_ERROR_BALANCE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// The radii that are compared, in edge lengths: 2, 2.8, 4, 5.7, 8, 11.3 and 16. Below two edges there are too few
/// vertices for a fit, and beyond 16 a spider costs more than it gains.
constexpr int number_of_rungs = 7;

template <typename Scalar>
Scalar rung(Scalar index)
{
  return std::pow(Scalar(2), 1 + index / 2);
}

/// Mean curvatures at one vertex and their standard errors, in units of one over the edge length, one for each rung up
/// to the last usable one.
template <typename Scalar>
struct Rung_values
{
  std::array<Scalar, number_of_rungs> mean_curvatures, standard_errors;
  int usable = 0;
};

/// returns where the parabola through the least of the first values and those beside it is least, in logarithms.
template <typename Scalar, std::size_t N>
Scalar least_between(const std::array<Scalar, N>& values, int count)
{
  const int best = static_cast<int>(std::min_element(values.begin(), values.begin() + count) - values.begin());
  if(best == 0 || best + 1 == count)
    return Scalar(best);
  const Scalar before = std::log(values[best - 1] / values[best]), after = std::log(values[best + 1] / values[best]);
  const Scalar sum = before + after;
  return best + (sum > 0 && std::isfinite(sum) ? (before - after) / (2 * sum) : Scalar(0));
}

template <typename Scalar>
class Error_balance
{
public:
  using Samples = std::vector<Rung_values<Scalar>>;

  /// All rungs are compared on the same vertices; near borders only small radii are usable, and these vertices are left
  /// out as long as enough others remain.
  explicit Error_balance(const Samples& samples)
  {
    constexpr std::size_t fewest = 8, share = 5; // a fifth of those that at least the first two rungs are usable for
    const auto count_from = [&](int rungs) {
      return static_cast<std::size_t>(
        std::count_if(samples.begin(), samples.end(), [&](const auto& sample) { return sample.usable >= rungs; }));
    };
    const std::size_t needed = std::max(fewest, (count_from(2) + share - 1) / share);
    while(rungs_ < number_of_rungs && count_from(rungs_ + 1) >= needed)
      ++rungs_;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(samples_),
                 [&](const auto& sample) { return sample.usable >= rungs_; });
    if(rungs_ < 2)
      return;
    for(int k = 0; k + 1 < rungs_; ++k)
      steps_[k] = mean_square([&](const auto& H) { return H[k + 1] - H[k]; });
    tell_noise();
    tell_bias();
  }

  /// returns whether the last step is so much larger than the least error that no larger radius will be better.
  bool is_settled() const
  {
    constexpr Scalar hopeless = 4 * 4;
    return rungs_ > 2 && steps_[rungs_ - 2] > hopeless * error(best_rung());
  }

  /// returns the radius of least error in edge lengths, if there is enough to judge by: vertices, and differences that
  /// rounding doesn't explain.
  std::optional<Scalar> best_radius() const
  {
    constexpr Scalar rounding = Scalar(1e-9); // a surface that bends by less per edge is a plane
    if(rungs_ < 2 || !(*std::max_element(steps_.begin(), steps_.begin() + rungs_ - 1) > rounding * rounding))
      return {};
    Values errors{};
    for(int k = 0; k < rungs_; ++k)
      errors[k] = error(k);
    return rung(least_between(errors, rungs_));
  }

private:
  using Values = std::array<Scalar, number_of_rungs>;

  /// returns the square that the mean of absolute values stands for if they are normally distributed: a few vertices at
  /// creases, or at the tip of an ellipsoid, shall not decide for all.
  template <typename Term>
  Scalar mean_square(const Term& term) const
  {
    const Scalar half_pi = std::acos(Scalar(0));
    Scalar sum = 0;
    for(const auto& sample : samples_)
      sum += std::abs(term(sample.mean_curvatures));
    const Scalar mean = sum / static_cast<Scalar>(samples_.size());
    return half_pi * mean * mean;
  }

  /// Standard errors are those of noise and of whatever else the fits leave over, so they are no more than upper
  /// bounds. On the first rung, of two edges, there is no more than its step shows, of which at least two thirds are
  /// gone on the next one. From there on noise falls by three tenths or more, even where more is told of terms of
  /// higher degrees meanwhile. Estimators that tell no standard errors are bound by the steps alone, and by a fall to a
  /// quarter.
  void tell_noise()
  {
    constexpr Scalar least_fall = Scalar(0.7), untold_fall = Scalar(0.25), left_by_step = Scalar(1) / 3;
    for(int k = 0; k < rungs_; ++k)
    {
      const std::optional<Scalar> told = squared_standard_error(k);
      const Scalar fall = !told ? untold_fall : k == 1 ? left_by_step : least_fall;
      const Scalar bound = k == 0 ? steps_[0] / (1 - left_by_step) : fall * noise_[k - 1];
      noise_[k] = told ? std::min(*told, bound) : bound;
    }
  }

  std::optional<Scalar> squared_standard_error(int k) const
  {
    constexpr Scalar told_too_small = Scalar(1.2); // errors are 1.1 times as large where vertices are regular
    Scalar sum = 0;
    std::size_t count = 0;
    for(const auto& sample : samples_)
      if(const Scalar error = sample.standard_errors[k]; std::isfinite(error))
      {
        sum += error;
        ++count;
      }
    if(count == 0)
      return {};
    const Scalar mean = sum / static_cast<Scalar>(count);
    return told_too_small * mean * mean;
  }

  /// The best linear estimates at two radii differ by what the smaller one has more of noise (Hausman), and beyond that
  /// by bias: at each rung it is the sum of the steps up to there. That it may turn round is no reason to believe large
  /// radii. The rungs whose steps noise hides have some as well: a third of the first step that noise doesn't hide, where
  /// terms of higher degrees are told and bias is of the fourth order; all of that step where they aren't, and it is of
  /// the second.
  void tell_bias()
  {
    // Standard errors may be wrong by 15 %, and a mean square over n vertices by two times 1.5 / sqrt(n).
    const Scalar tolerance = Scalar(1.15) + 3 / std::sqrt(static_cast<Scalar>(samples_.size()));
    constexpr Scalar hidden = Scalar(0.5); // between a third and all
    Scalar bias = bias_[0] = 0;
    for(int k = 1; k < rungs_; ++k)
    {
      const Scalar excess = steps_[k - 1] - tolerance * (noise_[k - 1] - noise_[k]);
      const Scalar step = std::sqrt(std::max(excess, Scalar(0)));
      bias += bias > 0 ? step : (1 + hidden) * step;
      bias_[k] = bias * bias;
    }
  }

  Scalar error(int k) const { return noise_[k] + bias_[k]; }

  int best_rung() const
  {
    int best = 0;
    for(int k = 1; k < rungs_; ++k)
      if(error(k) < error(best))
        best = k;
    return best;
  }

  Samples samples_;
  int rungs_ = 1;
  Values steps_{}, noise_{}, bias_{}; ///< squares: of the step to the next rung, and of the errors at each
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_ERROR_BALANCE_H
