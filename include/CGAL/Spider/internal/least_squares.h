// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Small weighted least squares.

#ifndef CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H
#define CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H

#include <algorithm>
#include <array>

namespace CGAL {
namespace Spider {
namespace internal {

/// The normal equations of a model that is linear in `Size` terms, of which the first is constant: sums over rows of
/// the products of two terms each, and of terms and the values there, which take the place behind the last term.
/// `Value` is a number, or several numbers in lanes.
template <typename Value, int Size>
struct Normal_equations
{
  static constexpr int values = Size;

  std::array<std::array<Value, Size + 1>, Size + 1> products; ///< the upper triangle

  /// starts without any row.
  Normal_equations()
  {
    products[0].fill(Value(0));
    products.fill(products[0]);
  }
};

/// Normal equations of which terms are eliminated, one after the other. What is left are those of the other terms, for
/// what the eliminated ones don't explain of them and of the values. A term of which too little is left to be told from
/// rounding is left out.
template <typename Scalar, int Size>
class Elimination
{
public:
  using Row = std::array<Scalar, Size + 1>; ///< a number for each term and, last, for the values

  explicit Elimination(const Normal_equations<Scalar, Size>& equations) : left_(equations.products)
  {
    inverse_.fill(0);
    for(int i = 0; i <= Size; ++i)
      squares_[i] = left_[i][i];
  }

  /// adds what rows would that say that the coefficient of a term not eliminated yet is zero.
  void damp(int term, Scalar square)
  {
    left_[term][term] += square;
    squares_[term] += square;
  }

  /// eliminates the terms from `first` to that before `last`; those before are eliminated already.
  void eliminate(int first, int last)
  {
    for(int k = first; k < last; ++k)
    {
      constexpr Scalar least_share = Scalar(1e-8);
      inverse_[k] = left_[k][k] > least_share * squares_[k] ? 1 / left_[k][k] : Scalar(0);
      const Row row = left_[k];
      for(int i = k + 1; i <= Size; ++i)
      {
        const Scalar factor = row[i] * inverse_[k];
        for(int j = 0; j <= Size; ++j) // all of the row, in whole packs: what is below the diagonal isn't read
          left_[i][j] -= factor * row[j];
      }
    }
  }

  /// tells whether a term was eliminated and not left out.
  bool has(int term) const { return inverse_[term] > 0; }

  /// The values' squares, what is left of them, and what is left of a term's squares.
  Scalar squared_values() const { return squares_[Size]; }
  Scalar unexplained() const { return std::max(left_[Size][Size], Scalar(0)); }
  Scalar left_of(int term) const { return left_[term][term]; }

  /// returns the coefficients of the eliminated terms as if there were no others, and 0 of the others.
  Row coefficients() const
  {
    Row left, coefficients{};
    for(int i = 0; i < Size; ++i)
      left[i] = left_[i][Size];
    for(int k = Size; k-- > 0;)
    {
      coefficients[k] = left[k] * inverse_[k];
      for(int i = 0; i < k; ++i)
        left[i] -= left_[i][k] * coefficients[k];
    }
    return coefficients;
  }

  /// returns the variance of a linear function of the coefficients if that of noise is 1.
  Scalar variance(Row function) const
  {
    Scalar sum = 0;
    for(int k = 0; k < Size; ++k)
    {
      const Scalar factor = function[k] * inverse_[k];
      sum += factor * function[k];
      for(int j = 0; j <= Size; ++j)
        function[j] -= j > k ? factor * left_[k][j] : Scalar(0);
    }
    return sum;
  }

private:
  std::array<Row, Size + 1> left_; ///< the upper triangle; of eliminated terms as they were left by those before
  Row inverse_;                    ///< of what was left of eliminated terms' squares, 0 for all others
  Row squares_;                    ///< the diagonal, as it was
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LEAST_SQUARES_H
