// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Least squares with terms of which it is known how large their coefficients may be expected to be.

#ifndef CGAL_SPIDER_INTERNAL_EXPECTED_TERMS_H
#define CGAL_SPIDER_INTERNAL_EXPECTED_TERMS_H

#include <CGAL/Spider/internal/least_squares.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Spider {
namespace internal {

/// The best linear predictor of a model's coefficients, given the variance of noise: the first `Free` terms may be as
/// they like, those of the others are zero on average and their squares are as expected. The noise by what is expected
/// joins the diagonal of the normal equations. So a term that the rows tell well is fitted, and one that they don't
/// tell better than noise does stays near zero.
template <int Free, typename Scalar, int Size>
class Expected_terms
{
  using Equations = Normal_equations<Scalar, Size>;
  using Terms = Orthonormal_terms<Size, Scalar, Size>;

public:
  using Row = std::array<Scalar, Size>;
  using Squares = std::array<Scalar, Size - Free>;

  Expected_terms(const Equations& equations, const Squares& expected, Scalar noise)
    : Expected_terms(with_penalties(equations, expected, noise), noise)
  {}

  const Row& coefficients() const { return coefficients_; }

  /// returns what is left of the values' squares, and what the coefficients cost by what is expected of them.
  Scalar unexplained() const { return std::max(terms_.unexplained(), Scalar(0)); }

  /// returns what is left of the values' squares.
  Scalar misfit(const Squares& expected) const
  {
    Scalar left = terms_.unexplained();
    for(int i = Free; i < Size; ++i)
      left -= noise_ / expected[i - Free] * coefficients_[i] * coefficients_[i];
    return std::max(left, Scalar(0));
  }

  /// returns the error to expect of a linear function of the coefficients, by noise and by what is damped.
  Scalar standard_error(const Row& function) const { return std::sqrt(noise_ * terms_.variance(function, 1)); }

private:
  Expected_terms(const Equations& with_penalties, Scalar noise)
    : noise_(noise), terms_(with_penalties), coefficients_(terms_.coefficients(1))
  {}

  static Equations with_penalties(Equations equations, const Squares& expected, Scalar noise)
  {
    for(int i = Free; i < Size; ++i)
      equations.matrix[i][i] += noise / expected[i - Free];
    return equations;
  }

  Scalar noise_;
  Terms terms_;
  Row coefficients_;
};

/// returns the normal equations of all but the first terms, for what those leave of the values and of the others.
template <int First, typename Scalar, int Size>
Normal_equations<Scalar, Size - First> beside_first_terms(Normal_equations<Scalar, Size> equations)
{
  auto& [matrix, right_side, squared_values] = equations;
  for(int k = 0; k < First; ++k)
  {
    for(int i = k + 1; i < Size; ++i)
    {
      const Scalar factor = matrix[i][k] / matrix[k][k];
      for(int j = k + 1; j <= i; ++j)
        matrix[i][j] -= factor * matrix[j][k];
      right_side[i] -= factor * right_side[k];
    }
    squared_values -= right_side[k] * right_side[k] / matrix[k][k];
  }
  Normal_equations<Scalar, Size - First> left;
  for(int i = First; i < Size; ++i)
  {
    std::copy(matrix[i].begin() + First, matrix[i].end(), left.matrix[i - First].begin());
    left.right_side[i - First] = right_side[i];
  }
  left.squared_values = squared_values;
  return left;
}

/// returns the variance of noise that what all terms leave of the values lets be at most, by two standard deviations of
/// such an estimate; infinite where it isn't independent in more values than there are terms to be fitted beside those
/// that are fitted already.
template <typename Scalar, int Size>
Scalar most_noise_beside_all_terms(const Normal_equations<Scalar, Size>& equations, Scalar independent_values)
{
  const Scalar count = independent_values - Size;
  if(!(count > 0))
    return std::numeric_limits<Scalar>::infinity();
  const Scalar left = std::max(Orthonormal_terms<Size, Scalar, Size>(equations).unexplained(), Scalar(0));
  return left / count * (1 + 2 * std::sqrt(2 / count));
}

/// returns the variance of noise, given in how many values it is independent. If that and the expected squares are
/// right, what `Expected_terms` leaves unexplained is on average as many times the variance as there are such values
/// beyond the free terms; so the variance is sought that fits, from above. Where values are fewer than terms, more than
/// is expected of these can't but be noise. The free terms have to be determined.
template <int Free, typename Scalar, int Size>
Scalar noise_beside_expected_terms(const Normal_equations<Scalar, Size>& equations,
                                   std::array<Scalar, Size - Free> expected, Scalar independent_values)
{
  // Terms larger than expected mustn't pass for noise, which would damp them: ten times as large ones are taken for
  // likely here. Under noise that changes nothing; without, it halves the error.
  constexpr Scalar generosity = 100; // of squares
  // Under noise, one round tells as much as any number. Without, each lowers what is left of it. Measured: at a radius of
  // two edges, eight have half the error of three, and at four 3 % less.
  constexpr int rounds = 8;
  for(Scalar& square : expected)
    square *= generosity;
  const auto left = beside_first_terms<Free>(equations);
  const Scalar values = independent_values - Free, count = std::max(values, Scalar(1));
  // Noise isn't below rounding, so that what is flat but for rounding is told from what is bent.
  const Scalar least = std::numeric_limits<Scalar>::epsilon() * equations.squared_values / count;
  Scalar noise = left.squared_values / count;
  for(int round = 0; round < rounds; ++round)
    noise = Expected_terms<0, Scalar, Size - Free>(left, expected, std::max(noise, least)).unexplained() / count;
  return std::max(std::min(noise, most_noise_beside_all_terms(left, values)), least);
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_EXPECTED_TERMS_H
