// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_FIT_EXPECTED_TERMS_H
#define CGAL_SPIDER_INTERNAL_FIT_EXPECTED_TERMS_H

#include <CGAL/Spider/internal/Expected_terms.h>
#include <CGAL/Spider/internal/height_field.h>
#include <CGAL/Spider/internal/least_squares.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace internal {

/// fits all terms of a height field, those above the quadratic ones expected to be as large as these let expect, and
/// returns what there is at a point; undetermined where the quadratic terms are, or are too small for their powers not
/// to vanish. Without noise that is the whole polynomial, and with much noise the quadric.
template <int Degree, typename Scalar>
Local_field<Scalar> fit_expected_terms(const Normal_equations<Scalar, Height_field_basis<Degree>::size>& equations,
                                       Scalar independent_values, Scalar x, Scalar y)
{
  using Basis = Height_field_basis<Degree>;
  const Orthonormal_terms<Basis::quadratic, Scalar, Basis::size> plain(equations);
  for(int i = 0; i < Basis::quadratic; ++i)
    if(!plain.has(i))
      return {};
  const auto expected = Basis::expected_squares(Basis::squared_curvature(plain.coefficients(0)));
  if(!(expected.back() > 0))
    return {};
  const Scalar noise = noise_beside_expected_terms<Basis::quadratic>(equations, expected, independent_values);
  const Expected_terms<Basis::quadratic, Scalar, Basis::size> terms(equations, expected, noise);

  std::array<Scalar, Basis::size> mean_of_second_derivatives; // what each term adds to that by x and by y
  for(int i = 0; i < Basis::size; ++i)
  {
    std::array<Scalar, Basis::size> term{};
    term[i] = 1;
    const Derivatives<Scalar> d = Basis::derivatives_at(term, x, y);
    mean_of_second_derivatives[i] = (d.xx + d.yy) / 2;
  }
  Local_field<Scalar> field;
  field.derivatives = Basis::derivatives_at(terms.coefficients(), x, y);
  field.residual = std::sqrt(terms.misfit(expected) / equations.matrix[Basis::constant][Basis::constant]);
  field.standard_error = terms.standard_error(mean_of_second_derivatives);
  field.independent_values = independent_values;
  field.determined = std::isfinite(field.derivatives.xx + field.derivatives.xy + field.derivatives.yy) &&
                     std::isfinite(field.standard_error);
  return field;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_FIT_EXPECTED_TERMS_H
