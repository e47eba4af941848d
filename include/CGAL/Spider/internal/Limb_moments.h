// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_LIMB_MOMENTS_H
#define CGAL_SPIDER_INTERNAL_LIMB_MOMENTS_H

#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/height_field.h>
#include <CGAL/Spider/internal/least_squares.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spider {
namespace internal {

/// What the samples of limbs in lockstep add to the normal equations of a height field.
///
/// On a limb, a linear or neglected term is a power of the distance y from the query point, times a factor that depends
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
    Weighted_powers powers = {weight, weight * y};
    if constexpr(Basis::neglected > 0)
    {
      const Values squared = y * y, fourth = squared * squared;
      powers[2] = weight * fourth;
      moments_[3] += powers[2];
      moments_[4] += powers[2] * y;
      moments_[5] += powers[2] * fourth;
    }
    moments_[0] += powers[0];
    moments_[1] += powers[1];
    moments_[2] += powers[1] * y;
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
    std::array<int, Basis::linear + Basis::neglected> terms;
    std::array<Values, Basis::linear + Basis::neglected> turning;
    CGAL_SPIDER_FOR_EACH(i, 0, Basis::linear + Basis::neglected)
    {
      terms[i] = i < Basis::linear ? i : Basis::curved + i;
      turning[i] = Basis::turning(terms[i], cosine, sine);
      CGAL_SPIDER_FOR_EACH(k, 0, i + 1)
        equations.matrix[terms[i]][terms[k]] += turning[i] * turning[k] * moment(terms[i], terms[k]);
      equations.right_side[terms[i]] += turning[i] * mixed_[height][power(terms[i])];
      CGAL_SPIDER_FOR_EACH(k, 0, Basis::curved)
        (i < Basis::linear ? equations.matrix[Basis::linear + k][i] : equations.matrix[terms[i]][Basis::linear + k]) +=
          turning[i] * mixed_[k][power(terms[i])];
    }
    CGAL_SPIDER_FOR_EACH(i, 0, Basis::curved)
    {
      CGAL_SPIDER_FOR_EACH(k, 0, i + 1)
        equations.matrix[Basis::linear + i][Basis::linear + k] += products_[i][k];
      equations.right_side[Basis::linear + i] += products_[height][i];
    }
    equations.squared_values += products_[height][height];
  }

private:
  /// The powers 0, 1 and 4 of the distance.
  static constexpr int number_of_powers = Basis::neglected > 0 ? 3 : 2;
  using Weighted_powers = std::array<Values, 3>;

  static constexpr int power(int term) { return Basis::degree(term) == 4 ? 2 : Basis::degree(term); }

  const Values& moment(int i, int k) const
  {
    switch(Basis::degree(i) + Basis::degree(k))
    {
      case 0: return moments_[0];
      case 1: return moments_[1];
      case 2: return moments_[2];
      case 4: return moments_[3];
      case 5: return moments_[4];
      default: return moments_[5];
    }
  }

  std::array<Values, 6> moments_;                                      ///< of the powers 0, 1, 2, 4, 5 and 8
  std::array<std::array<Values, number_of_powers>, height + 1> mixed_; ///< of the powers 0, 1, 4, and the functions
  std::array<std::array<Values, height + 1>, height + 1> products_;    ///< of two functions each, a lower triangle
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LIMB_MOMENTS_H
