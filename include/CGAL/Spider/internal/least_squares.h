// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Small weighted least squares.

#ifndef CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H
#define CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H

#include <CGAL/Spider/internal/unrolled_loops.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace internal {

/// The normal equations of a model that is linear in `Size` terms, of which the first is constant: sums over rows of
/// terms and the values there. `Value` is a number, or several numbers in lanes.
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

  Coefficients plain;        ///< as if there were no neglected terms; 0 of those that the rows don't determine
  Coefficients coefficients; ///< without the neglected terms' effect, as far as that was taken back
  std::array<bool, Size> determined;
  Scalar residual;               ///< root mean square
  Scalar independent_values;     ///< in which noise is independent
  Scalar share_of_neglected = 0; ///< how much of the neglected terms' effect was taken back
  Scalar standard_error;         ///< of the coefficient that was asked for
};

/// The Cholesky factorization of normal equations whose terms were scaled to a unit diagonal. A pivot is the share of a
/// term that the terms before it don't explain: a term of which less is left than its least pivot is left out.
template <typename Scalar, int Size>
struct Cholesky
{
  std::array<std::array<Scalar, Size>, Size> lower; ///< below the diagonal
  std::array<Scalar, Size> inverse;                 ///< of the diagonal, 0 for terms that are left out

  template <typename LeastPivot>
  Cholesky(const std::array<std::array<Scalar, Size>, Size>& matrix, const std::array<Scalar, Size>& scale,
           const LeastPivot& least_pivot)
  {
    CGAL_SPIDER_FOR_EACH(i, 0, Size)
      CGAL_SPIDER_FOR_EACH(k, 0, i + 1)
        lower[i][k] = matrix[i][k] * scale[i] * scale[k];
    // Column by column: what is left of all later columns doesn't have to wait for one another.
    CGAL_SPIDER_FOR_EACH(k, 0, Size)
    {
      const Scalar pivot = lower[k][k];
      inverse[k] = pivot > least_pivot(k) ? 1 / std::sqrt(pivot) : Scalar(0);
      CGAL_SPIDER_FOR_EACH(i, k + 1, Size)
        lower[i][k] *= inverse[k];
      CGAL_SPIDER_FOR_EACH(j, k + 1, Size)
        CGAL_SPIDER_FOR_EACH(i, j, Size)
          lower[i][j] -= lower[i][k] * lower[j][k];
    }
  }

  void substitute_forward(std::array<Scalar, Size>& x) const
  {
    CGAL_SPIDER_FOR_EACH(j, 0, Size)
    {
      x[j] *= inverse[j];
      CGAL_SPIDER_FOR_EACH(i, j + 1, Size)
        x[i] -= lower[i][j] * x[j];
    }
  }

  void substitute_backward(std::array<Scalar, Size>& x) const
  {
    CGAL_SPIDER_FOR_EACH(k, 0, Size)
    {
      const int j = Size - 1 - k;
      x[j] *= inverse[j];
      CGAL_SPIDER_FOR_EACH(i, 0, j)
        x[i] -= lower[j][i] * x[j];
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

/// Normal equations in coordinates in which terms are orthonormal: each explains its square of the values' squares, and
/// noise is the same in all. The terms from `Fitted` on are those that the ones before them neglect.
template <int Fitted, typename Scalar, int Size>
class Orthonormal_terms
{
public:
  using Row = std::array<Scalar, Size>;

  explicit Orthonormal_terms(const Normal_equations<Scalar, Size>& equations)
    : squared_values_(equations.squared_values), scale_(scale_of(equations.matrix)),
      cholesky_(equations.matrix, scale_, least_pivot)
  {
    for(int i = 0; i < Size; ++i)
      values_[i] = scale_[i] * equations.right_side[i];
    cholesky_.substitute_forward(values_);
  }

  bool has(int term) const { return cholesky_.inverse[term] > 0; }

  /// returns what the fitted terms leave of the values' squares.
  Scalar unexplained() const
  {
    Scalar left = squared_values_;
    for(int i = 0; i < Fitted; ++i)
      left -= values_[i] * values_[i];
    return left;
  }

  Scalar explained_by_neglected() const
  {
    Scalar sum = 0;
    for(int i = Fitted; i < Size; ++i)
      sum += values_[i] * values_[i];
    return sum;
  }

  /// returns what the neglected terms would explain if their coefficients were 1: the trace of a Schur complement,
  /// which is the same whichever way axes are turned.
  Scalar explained_by_ones() const
  {
    Scalar trace = 0;
    for(int i = Fitted; i < Size; ++i)
      if(has(i))
      {
        Scalar left = 1 / (cholesky_.inverse[i] * cholesky_.inverse[i]);
        for(int j = Fitted; j < i; ++j)
          left += cholesky_.lower[i][j] * cholesky_.lower[i][j];
        trace += left / (scale_[i] * scale_[i]);
      }
    return trace;
  }

  /// returns the coefficients of all terms, with the given share of the neglected ones.
  Row coefficients(Scalar share) const
  {
    Row result = values_;
    for(int i = Fitted; i < Size; ++i)
      result[i] *= share;
    cholesky_.substitute_backward(result);
    for(int i = 0; i < Size; ++i)
      result[i] *= scale_[i];
    return result;
  }

  /// returns the variance of a linear function of `coefficients(share)` if that of noise is 1.
  Scalar variance(const Row& function, Scalar share) const
  {
    Row part;
    for(int i = 0; i < Size; ++i)
      part[i] = scale_[i] * function[i];
    cholesky_.substitute_forward(part);
    Scalar sum = 0;
    for(int i = 0; i < Size; ++i)
    {
      const Scalar shared = i < Fitted ? part[i] : share * part[i];
      sum += shared * shared;
    }
    return sum;
  }

private:
  static Scalar least_pivot(int term) { return term < Fitted ? Scalar(1e-8) : Scalar(1e-4); }

  static Row scale_of(const std::array<Row, Size>& matrix)
  {
    Row scale;
    for(int i = 0; i < Size; ++i)
      scale[i] = matrix[i][i] > 0 ? 1 / std::sqrt(matrix[i][i]) : Scalar(0);
    return scale;
  }

  Scalar squared_values_;
  Row scale_; ///< by which the matrix gets a unit diagonal
  Cholesky<Scalar, Size> cholesky_;
  Row values_;
};

/// fits the first `Fitted` terms. The others are terms that these neglect, and what they do to the fitted ones is taken
/// back by the share that `share_of(neglected_terms)` tells. `independent_values` is the number of values in which
/// noise is independent: it has the residual tell that of noise, and the standard error that it leaves in the
/// coefficient of `Term`.
template <int Fitted, int Term, typename Scalar, int Size, typename ShareOf>
Least_squares_fit<Scalar, Size> solve(const Normal_equations<Scalar, Size>& equations, Scalar independent_values,
                                      const ShareOf& share_of)
{
  const Orthonormal_terms<Fitted, Scalar, Size> terms(equations);
  Scalar unexplained = terms.unexplained();
  const Scalar explained_by_neglected = terms.explained_by_neglected();
  const Scalar noise = std::max(unexplained - explained_by_neglected, Scalar(0)) / independent_values;

  Least_squares_fit<Scalar, Size> fit;
  fit.independent_values = independent_values;
  fit.coefficients = fit.plain = terms.coefficients(0);
  if constexpr(Size > Fitted)
  {
    constexpr Scalar count = Size - Fitted;
    const Scalar share = share_of(Neglected_terms<Scalar, Size>{fit.plain, terms.explained_by_ones() / count, noise});
    fit.coefficients = terms.coefficients(share);
    fit.share_of_neglected = share;
    unexplained -= share * (2 - share) * explained_by_neglected;
  }
  std::array<Scalar, Size> term{};
  term[Term] = 1;
  fit.standard_error = std::sqrt(noise * terms.variance(term, fit.share_of_neglected));
  for(int i = 0; i < Size; ++i)
    fit.determined[i] = terms.has(i) && std::isfinite(fit.coefficients[i]);
  fit.residual = std::sqrt(std::max(unexplained, Scalar(0)) / equations.matrix[0][0]);
  return fit;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H
