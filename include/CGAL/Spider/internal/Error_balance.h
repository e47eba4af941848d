// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How wrong mean curvature is at each radius of a ladder, and at which radius it is least so: told from the answers
// alone, at a sample of vertices, without the truth. Where answers at successive radii differ, either noise was in the
// smaller one or bias is in the larger one. Noise falls with the radius and bias grows, both at known rates: so there
// is no more noise at a radius than smaller ones show, and no more bias than larger ones do.

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

/// Mean curvatures at one vertex, in units of one over the edge length, one for each rung up to the last usable one.
template <typename Scalar>
struct Rung_values
{
  std::array<Scalar, number_of_rungs> mean_curvatures;
  int usable = 0;
};

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
    bound_noise();
    bound_bias();
    measure_bias_of_large_radii();
  }

  /// returns whether the last step is so much larger than the least error that no larger radius will be better.
  bool is_settled() const
  {
    constexpr Scalar hopeless = 4 * 4;
    return rungs_ > 2 && steps_[rungs_ - 2] > hopeless * (noise_[best_rung()] + bias_[best_rung()]);
  }

  /// returns the radius of least error in edge lengths, if there is enough to judge by: vertices, and differences that
  /// rounding doesn't explain.
  std::optional<Scalar> best_radius() const
  {
    constexpr Scalar rounding = Scalar(1e-9); // a surface that bends by less per edge is a plane
    if(rungs_ < 2 || !(*std::max_element(steps_.begin(), steps_.begin() + rungs_ - 1) > rounding * rounding))
      return {};
    return radius_of_least_error();
  }

private:
  using Values = std::array<Scalar, number_of_rungs>;

  /// How the variance of curvature falls with the radius in edge lengths, but for a factor. White noise would give its
  /// sixth power; facets interpolate the noise of vertices, and small spiders see less of it. Measured on all
  /// tessellations: the local power is 4.6 to 4.8 from two to four edges and 5.3 to 5.5 above eight, which this has too.
  static Scalar noise_law(Scalar radius)
  {
    constexpr Scalar interpolated = 4; // edge lengths
    const Scalar deviation = 1 / (radius * radius * (radius + interpolated));
    return deviation * deviation;
  }

  static Scalar noise_ratio(int of, int to) { return noise_law(rung(Scalar(of))) / noise_law(rung(Scalar(to))); }

  /// The best linear estimates at two radii differ by what the smaller one has more of noise (Hausman).
  static Scalar noise_of_step(int k) { return 1 - noise_ratio(k + 1, k); }

  /// By theory bias grows with the square of the radius, until the surface's own features end that; squares of bias by
  /// no less than this power.
  static Scalar bias_ratio(int of, int to)
  {
    constexpr Scalar least_power = Scalar(2.4);
    return std::pow(rung(Scalar(of)) / rung(Scalar(to)), least_power);
  }

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

  /// The noise at a rung is no more than what the step from any smaller one, or its own, leaves of it.
  void bound_noise()
  {
    noise_.fill(std::numeric_limits<Scalar>::infinity());
    for(int k = 0; k < rungs_; ++k)
      for(int from = 0; from <= std::min(k, rungs_ - 2); ++from)
        noise_[k] = std::min(noise_[k], steps_[from] / noise_of_step(from) * noise_ratio(k, from));
  }

  /// Bias doubles from one rung to the next, so it is as large as the step to the next one. It is no more than any
  /// larger rung's scaled down.
  void bound_bias()
  {
    constexpr Scalar tolerance = Scalar(1.15); // what the law of noise and the sample may be wrong by
    constexpr Scalar of_last = 4;              // (1 + 1)², for the last rung has no next one
    bias_.fill(std::numeric_limits<Scalar>::infinity());
    for(int from = 0; from + 1 < rungs_; ++from)
    {
      const Scalar bias = std::max(steps_[from] - tolerance * noise_of_step(from) * noise_[from], Scalar(0));
      for(int k = 0; k <= from; ++k)
        bias_[k] = std::min(bias_[k], bias * bias_ratio(k, from));
      bias_[rungs_ - 1] = of_last * bias;
    }
  }

  /// returns the rung of least error but for the last one.
  int best_rung() const
  {
    int best = 0;
    for(int k = 1; k + 1 < rungs_; ++k)
      if(noise_[k] + bias_[k] < noise_[best] + bias_[best])
        best = k;
    return best;
  }

  /// At large radii bias may turn round. There the estimate of a smaller radius tells it, which has little bias and
  /// that extrapolated to none: 2 H(m) - H(m + 1).
  void measure_bias_of_large_radii()
  {
    const int m = best_rung();
    for(int k = m + 2; k < rungs_; ++k)
    {
      const Scalar noise = 4 * noise_[m] - 3 * noise_[m + 1] - noise_[k];
      const Scalar square = mean_square([&](const auto& H) { return H[k] - (2 * H[m] - H[m + 1]); });
      bias_[k] = std::max(square - noise, Scalar(0));
    }
  }

  Scalar radius_of_least_error() const
  {
    constexpr int steps = 16; // by 2 % of the radius
    Scalar best = rung<Scalar>(0), least = noise_[0] + bias_[0];
    for(int k = 0; k + 1 < rungs_; ++k)
      for(int step = 1; step <= steps; ++step)
      {
        const Scalar share = Scalar(step) / steps, radius = rung(k + share);
        const Scalar noise = noise_[k] * noise_law(radius) / noise_law(rung(Scalar(k)));
        const Scalar error = noise + bias_[k] + share * (bias_[k + 1] - bias_[k]);
        if(error < least)
        {
          least = error;
          best = radius;
        }
      }
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
