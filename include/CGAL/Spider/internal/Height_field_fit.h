// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_HEIGHT_FIELD_FIT_H
#define CGAL_SPIDER_INTERNAL_HEIGHT_FIELD_FIT_H

#include <CGAL/Spider/internal/Expected_terms.h>
#include <CGAL/Spider/internal/height_field.h>
#include <CGAL/Spider/internal/least_squares.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace internal {

/// A height field whose terms up to the quadratic ones are as samples tell, and whose others are expected to be as
/// large as these let expect. Without noise that is the whole polynomial, and with much noise the quadric.
template <int Degree, typename Scalar>
class Height_field_fit
{
  using Basis = Height_field_basis<Degree>;
  static constexpr int free = Basis::quadratic, size = Basis::size;
  using Terms = Expected_terms<free, Scalar, size>;
  using Row = typename Terms::Row;

public:
  using Equations = Normal_equations<Scalar, size>;

  /// takes the normal equations, and in how many values noise is independent.
  Height_field_fit(const Equations& equations, Scalar independent_values)
    : sum_of_weights_(equations.products[Basis::constant][Basis::constant]), independent_values_(independent_values),
      quadric_(equations)
  {
    quadric_.eliminate(0, free);
    for(int i = 0; i < free; ++i)
      if(!quadric_.has(i))
        return;
    // A surface that bends by more than one over the radius isn't a height field any more: nothing follows from that.
    constexpr Scalar most = 1; // in units of the radius
    expected_ = Basis::expected_squares(std::min(Basis::squared_curvature(quadric_.coefficients()), most));
    expects_ = expected_.back() > 0;
    if(expects_)
      noise_ = noise_beside_expected_terms<free>(quadric_, expected_, independent_values);
  }

  /// returns which share noise has in what the quadric neglects, and quartic terms don't; all of it where these aren't
  /// expected.
  Scalar share_of_noise() const
  {
    if(!expects_)
      return 1;
    Scalar effect = 0;
    for(int i = Basis::quartic; i < size; ++i)
      effect += expected_[i - free] * quadric_.left_of(i) / (size - Basis::quartic);
    return noise_ / (noise_ + effect);
  }

  /// returns what there is at a point with the terms that are expected; undetermined where the quadric is, or is bent
  /// so little that the powers of its curvature vanish.
  Local_field<Scalar> at(Scalar x, Scalar y) const
  {
    if(!expects_)
      return {};
    const Terms terms(quadric_, expected_, noise_);
    const Row coefficients = terms.coefficients();
    Local_field<Scalar> field;
    field.derivatives = Basis::derivatives_at(coefficients, x, y);
    field.residual = std::sqrt(terms.misfit(coefficients, expected_) / sum_of_weights_);
    field.standard_error = terms.standard_error(mean_of_second_derivatives(x, y));
    field.independent_values = independent_values_;
    field.determined = std::isfinite(field.derivatives.xx + field.derivatives.xy + field.derivatives.yy) &&
                       std::isfinite(field.standard_error);
    return field;
  }

  /// returns what there is at the origin by the quadric alone, or by as much of it as samples determine.
  Local_field<Scalar> plain(bool is_complete) const
  {
    // A spider inside one face, or inside coplanar ones, sees a plane, and no more than that if it is complete.
    const bool is_flat = is_complete && !quadric_.has(Basis::isotropic);
    if(!quadric_.has(Basis::constant) || !quadric_.has(Basis::x_term) || !quadric_.has(Basis::y_term) ||
       !(quadric_.has(Basis::isotropic) || is_flat))
      return {};
    // Few vertices, or few limbs, may tell how much the surface bends but not in which direction it does so more.
    const bool has_directions = quadric_.has(Basis::difference) && quadric_.has(Basis::mixed) && !is_flat;
    Row coefficients = quadric_.coefficients();
    if(!has_directions)
      coefficients[Basis::difference] = coefficients[Basis::mixed] = 0;
    Local_field<Scalar> field;
    field.is_whole = has_directions || is_flat;
    field.derivatives = Basis::derivatives_at(coefficients, Scalar(0), Scalar(0));
    field.residual = std::sqrt(quadric_.unexplained() / sum_of_weights_);
    field.standard_error =
      std::sqrt(quadric_.unexplained() / independent_values_ * quadric_.variance(mean_of_second_derivatives(0, 0)));
    field.independent_values = independent_values_;
    field.determined = std::isfinite(field.derivatives.xx + field.derivatives.xy + field.derivatives.yy);
    return field;
  }

private:
  /// returns what each term adds to the mean of the second derivatives by x and by y.
  static Row mean_of_second_derivatives(Scalar x, Scalar y)
  {
    Row means{};
    for(int i = Basis::isotropic; i < Basis::fitted; ++i)
    {
      Row term{};
      term[i] = 1;
      const Derivatives<Scalar> d = Basis::derivatives_at(term, x, y);
      means[i] = (d.xx + d.yy) / 2;
    }
    return means;
  }

  Scalar sum_of_weights_, independent_values_;
  Elimination<Scalar, size> quadric_; ///< as far as samples determine it
  typename Terms::Squares expected_;
  bool expects_ = false; ///< anything
  Scalar noise_ = 0;     ///< its variance
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_HEIGHT_FIELD_FIT_H
