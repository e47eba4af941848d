// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_LIMB_MOMENTS_H
#define CGAL_SPIDER_INTERNAL_LIMB_MOMENTS_H

#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/height_field.h>
#include <CGAL/Spider/internal/least_squares.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Spider {
namespace internal {

/// What the samples of limbs in lockstep add to the normal equations of a height field.
///
/// On a limb, a linear or harmonic term is a power of the distance y from the query point, times a factor that depends
/// on the direction only. So of these, sums over samples of the weighted powers are enough, and of their products with
/// the other functions along the limb: the curved terms and the height.
template <typename Scalar, int Degree>
class Limb_moments
{
  using Values = Lanes<Scalar>;
  using Basis = Height_field_basis<Degree>;

public:
  static constexpr int height = Basis::curved; ///< the place of the height among the functions
  using Functions = std::array<Values, height + 1>;

  /// starts without any sample.
  void clear()
  {
    for(Values& moment : moments_)
      moment = Values(0);
    for(int i = 0; i <= height; ++i)
    {
      for(Values& moment : mixed_[i])
        moment = Values(0);
      for(Values& product : products_[i])
        product = Values(0);
    }
  }

  /// adds a sample of each limb at the distances `y`.
  void add(const Values& y, const Functions& functions, const Values& weight)
  {
    std::array<Values, number_of_powers> powers = {weight, weight * y};
    moments_[0] += powers[0];
    moments_[1] += powers[1];
    moments_[2] += powers[1] * y;
    if constexpr(Degree < 4)
    {
      const Values squared = y * y, third = squared * y, fourth = squared * squared;
      const Values weighted_fourth = weight * fourth;
      powers[power(4)] = weighted_fourth;
      moments_[4] += weighted_fourth;
      moments_[5] += weighted_fourth * y;
      moments_[8] += weighted_fourth * fourth;
      if constexpr(Degree < 3)
      {
        powers[power(3)] = weight * third;
        moments_[3] += powers[power(3)];
        moments_[6] += powers[power(3)] * third;
        moments_[7] += weighted_fourth * third;
      }
    }
    CGAL_SPIDER_FOR_EACH(i, 0, height + 1)
    {
      CGAL_SPIDER_FOR_EACH(k, 0, number_of_powers)
        mixed_[i][k] += powers[k] * functions[i];
      const Values weighted = weight * functions[i];
      CGAL_SPIDER_FOR_EACH(k, 0, i + 1)
        products_[i][k] += weighted * functions[k];
    }
  }

  /// takes over the samples of one limb.
  void take_lane(int lane, const Limb_moments& other)
  {
    const auto take = [&](auto& values, const auto& others) {
      for(std::size_t k = 0; k < values.size(); ++k)
        values[k].set(lane, others[k][lane]);
    };
    take(moments_, other.moments_);
    for(int i = 0; i <= height; ++i)
    {
      take(mixed_[i], other.mixed_[i]);
      take(products_[i], other.products_[i]);
    }
  }

  /// adds the samples of all limbs, given the cosines and sines of their directions, to the equations.
  void add_to(Normal_equations<Values, Basis::size>& equations, const Values& cosine, const Values& sine) const
  {
    auto& products = equations.products;
    std::array<Values, Basis::powers> turning;
    CGAL_SPIDER_FOR_EACH(i, 0, Basis::powers)
    {
      const int term = term_of_power(i);
      turning[i] = Basis::turning(term, cosine, sine);
      CGAL_SPIDER_FOR_EACH(k, 0, i + 1)
        products[term_of_power(k)][term] += turning[i] * turning[k] * moments_[degree(i) + degree(k)];
      CGAL_SPIDER_FOR_EACH(k, 0, height + 1)
      {
        const int other = term_of_function(k);
        products[std::min(term, other)][std::max(term, other)] += turning[i] * mixed_[k][power(degree(i))];
      }
    }
    CGAL_SPIDER_FOR_EACH(i, 0, height + 1)
      CGAL_SPIDER_FOR_EACH(k, 0, i + 1)
        products[term_of_function(k)][term_of_function(i)] += products_[i][k];
  }

private:
  /// The powers of the distance, 0, 1, and those of the degrees that aren't fitted.
  static constexpr int number_of_powers = 2 + Basis::highest_degree - Degree;
  static constexpr int power(int degree) { return degree > 1 ? degree - Degree + 1 : degree; }

  static constexpr int term_of_power(int i) { return i < Basis::linear ? i : Basis::curved + i; }
  static constexpr int term_of_function(int i) { return i < height ? Basis::linear + i : Basis::size; }
  static constexpr int degree(int i) { return Basis::degree(term_of_power(i)); }

  std::array<Values, 2 * Basis::highest_degree + 1> moments_;          ///< of the powers that products have
  std::array<std::array<Values, number_of_powers>, height + 1> mixed_; ///< of powers and functions
  std::array<std::array<Values, height + 1>, height + 1> products_;    ///< of two functions each, a lower triangle
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LIMB_MOMENTS_H
