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

/// returns how much of an effect to believe, by how far its mean square exceeds what noise alone would bring about. It
/// does so five times in one of three hundred cases (the F distribution with three and some fifty degrees of freedom);
/// beyond that, it is shrunk by that threshold as in the estimator of James and Stein.
template <typename Scalar>
Scalar proven_share(Scalar mean_square, Scalar mean_square_of_noise)
{
  constexpr Scalar threshold = 5;
  return mean_square > threshold * mean_square_of_noise ? 1 - threshold * mean_square_of_noise / mean_square
                                                        : Scalar(0);
}

template <typename Scalar, int Size>
struct Least_squares_fit
{
  std::array<Scalar, Size> coefficients; ///< 0 of terms that the rows don't determine
  std::array<bool, Size> determined;
  Scalar residual;                       ///< root mean square
  Scalar share_of_neglected = 0;         ///< how much of the neglected terms' effect was taken back
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

/// fits the first `Fitted` terms. The others are terms that these neglect: their effect on the fitted ones is taken back
/// as far as the values prove it. `independent_values` is the number of values in which noise is independent.
template <int Fitted, typename Scalar, int Size>
Least_squares_fit<Scalar, Size> solve(const Normal_equations<Scalar, Size>& equations, Scalar independent_values)
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
  Least_squares_fit<Scalar, Size> fit;
  if constexpr(Size > Fitted)
  {
    const Scalar noise = std::max(unexplained - explained_by_neglected, Scalar(0)) / independent_values;
    const Scalar share = proven_share(explained_by_neglected / (Size - Fitted), noise);
    for(int i = Fitted; i < Size; ++i)
      x[i] *= share;
    unexplained -= share * (2 - share) * explained_by_neglected;
    fit.share_of_neglected = share;
  }
  cholesky.substitute_backward(x);

  for(int i = 0; i < Size; ++i)
  {
    fit.coefficients[i] = scale[i] * x[i];
    fit.determined[i] = cholesky.inverse[i] > 0 && std::isfinite(fit.coefficients[i]);
  }
  fit.residual = std::sqrt(std::max(unexplained, Scalar(0)) / equations.matrix[0][0]);
  return fit;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H
