// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Small weighted least squares. Sums run over arrays of fixed size in plain loops, which compilers turn into vector
// code; what is done once for each fit is in Eigen's matrices of dynamic size, of which one instance serves all sizes.

#ifndef CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H
#define CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spider {
namespace internal {

/// The most terms that a fit has: a quartic in two variables.
constexpr int most_terms = 15;

template <typename Scalar>
using Small_matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, 0, most_terms, most_terms>;
template <typename Scalar>
using Small_vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1, 0, most_terms, 1>;

/// The normal equations of a model that is linear in `Size` terms: sums over rows of terms and the values there.
template <typename Scalar, std::size_t Size>
struct Normal_equations
{
  using Row = std::array<Scalar, Size>;

  std::array<Row, Size> matrix{};
  Row right_side{};
  Scalar squared_values = 0, weights = 0;

  void add(const Row& row, Scalar value, Scalar weight)
  {
    for(std::size_t i = 0; i < Size; ++i)
    {
      const Scalar weighted = weight * row[i];
      for(std::size_t k = 0; k < Size; ++k)
        matrix[i][k] += weighted * row[k];
      right_side[i] += weighted * value;
    }
    squared_values += weight * value * value;
    weights += weight;
  }

  void add(const Normal_equations& other, Scalar factor)
  {
    for(std::size_t i = 0; i < Size; ++i)
    {
      for(std::size_t k = 0; k < Size; ++k)
        matrix[i][k] += factor * other.matrix[i][k];
      right_side[i] += factor * other.right_side[i];
    }
    squared_values += factor * other.squared_values;
    weights += factor * other.weights;
  }
};

/// factorizes a matrix of normal equations whose diagonal is one. Then a pivot is the share of a term that the terms
/// before it don't explain: none if one is less than `least_pivot`.
template <typename Scalar>
std::optional<Eigen::LDLT<Small_matrix<Scalar>>> factorize(const Small_matrix<Scalar>& matrix, Scalar least_pivot)
{
  Eigen::LDLT<Small_matrix<Scalar>> factorization(matrix);
  for(Eigen::Index i = 0; i < matrix.rows(); ++i)
    if(!(factorization.vectorD()[i] > least_pivot))
      return std::nullopt;
  return factorization;
}

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

template <typename Scalar>
struct Least_squares_fit
{
  Small_vector<Scalar> coefficients; ///< of the fitted terms
  Scalar residual;                   ///< root mean square
};

/// `solve()` on equations whose terms were scaled to a unit diagonal.
template <typename Scalar>
std::optional<Least_squares_fit<Scalar>> solve_scaled(const Small_matrix<Scalar>& matrix,
                                                      const Small_vector<Scalar>& right_side,
                                                      const Small_vector<Scalar>& scale,
                                                      int fitted,
                                                      Scalar squared_values,
                                                      Scalar weights,
                                                      Scalar independent_values)
{
  constexpr Scalar least_pivot = Scalar(1e-8), least_pivot_of_neglected = Scalar(1e-4);
  const int neglected = static_cast<int>(matrix.rows()) - fitted;
  const auto factorization = factorize<Scalar>(matrix.topLeftCorner(fitted, fitted), least_pivot);
  if(!factorization)
    return std::nullopt;
  Small_vector<Scalar> x = factorization->solve(right_side.head(fitted));
  Scalar squared_residuals = squared_values - x.dot(right_side.head(fitted));

  if(neglected > 0)
  {
    // What is left of the neglected terms, and of the values, when the fitted terms are taken out of them.
    const Small_matrix<Scalar> coupling = matrix.topRightCorner(fitted, neglected);
    const Small_matrix<Scalar> effect = factorization->solve(coupling);
    Small_matrix<Scalar> left = matrix.bottomRightCorner(neglected, neglected);
    left -= coupling.transpose().lazyProduct(effect);
    Small_vector<Scalar> left_values = right_side.tail(neglected);
    left_values -= coupling.transpose().lazyProduct(x);
    if(const auto left_factorization = factorize<Scalar>(left, least_pivot_of_neglected))
    {
      const Small_vector<Scalar> amount = left_factorization->solve(left_values);
      const Scalar explained = amount.dot(left_values);
      const Scalar unexplained = std::max(squared_residuals - explained, Scalar(0));
      const Scalar share = proven_share(explained / neglected, unexplained / independent_values);
      x -= share * effect.lazyProduct(amount);
      squared_residuals -= share * (2 - share) * explained;
    }
  }
  if(!x.allFinite())
    return std::nullopt;
  return Least_squares_fit<Scalar>{scale.head(fitted).cwiseProduct(x),
                                   std::sqrt(std::max(squared_residuals, Scalar(0)) / weights)};
}

/// fits the first `fitted` terms. The others are terms that these neglect: their effect on the fitted ones is taken back
/// as far as the values prove it. `independent_values` is the number of values in which noise is independent.
/// None if the rows don't determine the fitted terms.
template <typename Scalar, std::size_t Size>
std::optional<Least_squares_fit<Scalar>>
solve(const Normal_equations<Scalar, Size>& equations, int fitted, Scalar independent_values)
{
  Small_matrix<Scalar> matrix(Size, Size);
  Small_vector<Scalar> scale(Size), right_side(Size);
  for(std::size_t i = 0; i < Size; ++i)
    scale[i] = 1 / std::sqrt(equations.matrix[i][i]);
  for(std::size_t i = 0; i < Size; ++i)
  {
    for(std::size_t k = 0; k < Size; ++k)
      matrix(i, k) = scale[i] * equations.matrix[i][k] * scale[k];
    right_side[i] = scale[i] * equations.right_side[i];
  }
  return solve_scaled<Scalar>(matrix, right_side, scale, fitted, equations.squared_values, equations.weights,
                              independent_values);
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H
