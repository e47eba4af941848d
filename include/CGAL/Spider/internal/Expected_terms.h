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
public:
  using Row = typename Elimination<Scalar, Size>::Row;
  using Squares = std::array<Scalar, Size - Free>;

  /// takes equations of which the free terms are eliminated.
  Expected_terms(const Elimination<Scalar, Size>& beside_free_terms, const Squares& expected, Scalar noise)
    : noise_(noise), terms_(beside_free_terms)
  {
    for(int i = Free; i < Size; ++i)
      terms_.damp(i, noise / expected[i - Free]);
    terms_.eliminate(Free, Size);
  }

  Row coefficients() const { return terms_.coefficients(); }

  /// returns what is left of the values' squares, and what the coefficients cost by what is expected of them.
  Scalar unexplained() const { return terms_.unexplained(); }

  /// returns what is left of the values' squares.
  Scalar misfit(const Row& coefficients, const Squares& expected) const
  {
    Scalar left = terms_.unexplained();
    for(int i = Free; i < Size; ++i)
      left -= noise_ / expected[i - Free] * coefficients[i] * coefficients[i];
    return std::max(left, Scalar(0));
  }

  /// returns the error to expect of a linear function of the coefficients, by noise and by what is damped.
  Scalar standard_error(const Row& function) const { return std::sqrt(noise_ * terms_.variance(function)); }

private:
  Scalar noise_;
  Elimination<Scalar, Size> terms_;
};

/// returns the variance of noise that what all terms leave of the values lets be at most, by two standard deviations of
/// such an estimate; infinite where it isn't independent in more values than there are terms.
template <int Free, typename Scalar, int Size>
Scalar most_noise_beside_all_terms(Elimination<Scalar, Size> beside_free_terms, Scalar independent_values)
{
  const Scalar count = independent_values - Size;
  if(!(count > 0))
    return std::numeric_limits<Scalar>::infinity();
  beside_free_terms.eliminate(Free, Size);
  return beside_free_terms.unexplained() / count * (1 + 2 * std::sqrt(2 / count));
}

/// returns the variance of noise, given equations of which the free terms are eliminated, and in how many values noise
/// is independent. If that and the expected squares are right, what `Expected_terms` leaves unexplained is on average
/// as many times the variance as there are such values beyond the free terms; so the variance is sought that fits, from
/// above. Where values are fewer than terms, more than is expected of these can't but be noise.
template <int Free, typename Scalar, int Size>
Scalar noise_beside_expected_terms(const Elimination<Scalar, Size>& beside_free_terms,
                                   std::array<Scalar, Size - Free> expected, Scalar independent_values)
{
  // Terms larger than expected mustn't pass for noise, which would damp them: ten times as large ones are taken for
  // likely here. Under noise that changes nothing; without, it halves the error.
  constexpr Scalar generosity = 100; // of squares
  // Under noise, one round tells as much as any number. Without, each lowers what is left of it. Measured: at a radius
  // of two edges, eight have half the error of three, and at four 3 % less.
  constexpr int most_rounds = 8;
  constexpr Scalar little_change = Scalar(0.05);
  for(Scalar& square : expected)
    square *= generosity;
  const Scalar count = std::max(independent_values - Free, Scalar(1));
  // Noise isn't below rounding, so that what is flat but for rounding is told from what is bent.
  const Scalar least = std::numeric_limits<Scalar>::epsilon() * beside_free_terms.squared_values() / count;
  const Scalar most = most_noise_beside_all_terms<Free>(beside_free_terms, independent_values);
  Scalar noise = std::max(std::min(beside_free_terms.unexplained() / count, most), least), change = noise;
  for(int round = 0; round < most_rounds && change > little_change * noise; ++round)
  {
    const Scalar before = noise;
    const Expected_terms<Free, Scalar, Size> terms(beside_free_terms, expected, before);
    noise = std::max(std::min(terms.unexplained() / count, before), least);
    change = before - noise;
  }
  return noise;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_EXPECTED_TERMS_H
