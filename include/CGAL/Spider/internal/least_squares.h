// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Small weighted least squares.

#ifndef CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H
#define CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace internal {

/// The normal equations of a model that is linear in `Size` terms, of which the first is constant: sums over rows of terms
/// and the values there. `Value` is a number, or several numbers in lanes.
template <typename Value, int Size>
struct Normal_equations
{
  using Row = std::array<Value, Size>;

  std::array<Row, Size> matrix; ///< its lower triangle
  Row right_side;
  Value squared_values;

  /// starts without any row.
  Normal_equations() : squared_values(0)
  {
    right_side.fill(Value(0));
    matrix.fill(right_side);
  }
};

template <typename Scalar, int Size>
struct Least_squares_fit
{
  using Coefficients = std::array<Scalar, Size>;

  Coefficients plain;                    ///< as if there were no neglected terms; 0 of those that the rows don't determine
  Coefficients coefficients;             ///< without the neglected terms' effect, as far as that was taken back
  std::array<bool, Size> determined;
  Scalar residual;                       ///< root mean square
  Scalar independent_values;             ///< in which noise is independent
  Scalar share_of_neglected = 0;         ///< how much of the neglected terms' effect was taken back
  Scalar standard_error;                 ///< of the coefficient that was asked for
};

/// The Cholesky factorization of normal equations whose terms were scaled to a unit diagonal. A pivot is the share of a
/// term that the terms before it don't explain: a term of which less is left than its least pivot is left out.
template <typename Scalar, int Size>
struct Cholesky
{
  std::array<std::array<Scalar, Size>, Size> lower;
  std::array<Scalar, Size> inverse; ///< of the diagonal, 0 for terms that are left out

  template <typename LeastPivot>
  Cholesky(const std::array<std::array<Scalar, Size>, Size>& matrix,
           const std::array<Scalar, Size>& scale,
           const LeastPivot& least_pivot)
  {
    for(int i = 0; i < Size; ++i)
    {
      Scalar pivot = matrix[i][i] * scale[i] * scale[i];
      for(int k = 0; k < i; ++k)
      {
        Scalar left = matrix[i][k] * scale[i] * scale[k];
        for(int j = 0; j < k; ++j)
          left -= lower[i][j] * lower[k][j];
        lower[i][k] = left * inverse[k];
        pivot -= lower[i][k] * lower[i][k];
      }
      inverse[i] = pivot > least_pivot(i) ? 1 / std::sqrt(pivot) : Scalar(0);
    }
  }

  void substitute_forward(std::array<Scalar, Size>& x) const
  {
    for(int i = 0; i < Size; ++i)
    {
      for(int j = 0; j < i; ++j)
        x[i] -= lower[i][j] * x[j];
      x[i] *= inverse[i];
    }
  }

  void substitute_backward(std::array<Scalar, Size>& x) const
  {
    for(int i = Size; i-- > 0;)
    {
      for(int j = i + 1; j < Size; ++j)
        x[i] -= lower[j][i] * x[j];
      x[i] *= inverse[i];
    }
  }
};

/// What is known of the terms that a fit neglects. Squares are what they explain of the values' squares, per term.
template <typename Scalar, int Size>
struct Neglected_terms
{
  const std::array<Scalar, Size>& plain; ///< the coefficients without them
  Scalar explained_by_ones;              ///< if their coefficients were 1
  Scalar noise;                          ///< what noise lets them explain
};

/// returns the share of neglected terms that the best linear predictor has, if the squares of their coefficients are
/// expected to be as given.
template <typename Scalar, int Size>
Scalar predicted_share(const Neglected_terms<Scalar, Size>& neglected, Scalar expected_square)
{
  const Scalar effect = expected_square * neglected.explained_by_ones;
  return effect > 0 ? effect / (effect + neglected.noise) : Scalar(0);
}

/// fits the first `Fitted` terms. The others are terms that these neglect, and what they do to the fitted ones is taken back
/// by the share that `share_of(neglected_terms)` tells. `independent_values` is the number of values in which noise is
/// independent: it has the residual tell that of noise, and the standard error that it leaves in the coefficient of `Term`.
template <int Fitted, int Term, typename Scalar, int Size, typename ShareOf>
Least_squares_fit<Scalar, Size> solve(const Normal_equations<Scalar, Size>& equations,
                                      Scalar independent_values,
                                      const ShareOf& share_of)
{
  constexpr Scalar least_pivot = Scalar(1e-8), least_pivot_of_neglected = Scalar(1e-4);
  std::array<Scalar, Size> scale, x;
  for(int i = 0; i < Size; ++i)
  {
    scale[i] = equations.matrix[i][i] > 0 ? 1 / std::sqrt(equations.matrix[i][i]) : Scalar(0);
    x[i] = scale[i] * equations.right_side[i];
  }
  const Cholesky<Scalar, Size> cholesky(equations.matrix, scale, [&](int i) {
    return i < Fitted ? least_pivot : least_pivot_of_neglected;
  });

  // In the coordinates that forward substitution leads to, terms are orthonormal: each explains its square.
  cholesky.substitute_forward(x);
  Scalar unexplained = equations.squared_values, explained_by_neglected = 0;
  for(int i = 0; i < Fitted; ++i)
    unexplained -= x[i] * x[i];
  for(int i = Fitted; i < Size; ++i)
    explained_by_neglected += x[i] * x[i];

  const auto coefficients_without = [&](Scalar share) {
    auto c = x;
    for(int i = Fitted; i < Size; ++i)
      c[i] *= share;
    cholesky.substitute_backward(c);
    for(int i = 0; i < Size; ++i)
      c[i] *= scale[i];
    return c;
  };
  // Noise is the same in all these coordinates.
  const Scalar noise = std::max(unexplained - explained_by_neglected, Scalar(0)) / independent_values;
  std::array<Scalar, Size> part_of_term{};
  part_of_term[Term] = scale[Term];
  cholesky.substitute_forward(part_of_term);

  Least_squares_fit<Scalar, Size> fit;
  fit.independent_values = independent_values;
  fit.coefficients = fit.plain = coefficients_without(0);
  if constexpr(Size > Fitted)
  {
    constexpr Scalar count = Size - Fitted;
    Scalar explained_by_ones = 0; // the trace of a Schur complement, which is the same whichever way axes are turned
    for(int i = Fitted; i < Size; ++i)
      if(cholesky.inverse[i] > 0)
      {
        Scalar left = 1 / (cholesky.inverse[i] * cholesky.inverse[i]);
        for(int j = Fitted; j < i; ++j)
          left += cholesky.lower[i][j] * cholesky.lower[i][j];
        explained_by_ones += left / (scale[i] * scale[i]);
      }
    const Scalar share = share_of(
      Neglected_terms<Scalar, Size>{fit.plain, explained_by_ones / count, noise});
    fit.coefficients = coefficients_without(share);
    fit.share_of_neglected = share;
    unexplained -= share * (2 - share) * explained_by_neglected;
  }
  Scalar variance = 0;
  for(int i = 0; i < Size; ++i)
  {
    const Scalar part = i < Fitted ? part_of_term[i] : fit.share_of_neglected * part_of_term[i];
    variance += part * part;
  }
  fit.standard_error = std::sqrt(noise * variance);
  for(int i = 0; i < Size; ++i)
    fit.determined[i] = cholesky.inverse[i] > 0 && std::isfinite(fit.coefficients[i]);
  fit.residual = std::sqrt(std::max(unexplained, Scalar(0)) / equations.matrix[0][0]);
  return fit;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H
