// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_HEIGHT_FIELD_H
#define CGAL_SPIDER_INTERNAL_HEIGHT_FIELD_H

#include <CGAL/Spider/internal/Spider_fit.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Spider {
namespace internal {

/// The number of monomials x^p y^q of degree p + q at most `degree`.
constexpr int number_of_monomials(int degree)
{
  return (degree + 1) * (degree + 2) / 2;
}

/// The first and second derivatives of a height field at a point.
template <typename Scalar>
struct Derivatives
{
  Scalar x, y, xx, xy, yy;
};

/// The terms of a height field z(x, y) up to the fourth degree, by degree: 1, x and y, and
/// - the curved ones: the quadratic ones by how they turn with the angle, x^2 + y^2, x^2 - y^2 and 2xy, and the
///   monomials x^3, x^2 y, ... of the degrees that are fitted;
/// - the harmonic ones, of the others: powers of the distance times cosines and sines of the angle's multiples.
template <int Degree>
struct Height_field_basis
{
  static constexpr int highest_degree = 4;
  static constexpr int linear = number_of_monomials(1), quadratic = number_of_monomials(2); ///< up to these
  static constexpr int quartic = number_of_monomials(3);                                    ///< the first one
  static constexpr int size = number_of_monomials(highest_degree);
  static constexpr int fitted = number_of_monomials(Degree);
  static constexpr int curved = fitted - linear;
  static constexpr int powers = size - curved; ///< the number of linear and harmonic terms
  enum { constant, x_term, y_term, isotropic, difference, mixed };

  /// The degree of the linear and of the harmonic terms.
  static constexpr int degree(int term)
  {
    return term < linear ? (term > constant ? 1 : 0) : term < quartic ? 3 : 4;
  }

  /// returns the curved terms at a point. `Value` is a number, or several numbers in lanes.
  template <typename Value>
  static std::array<Value, curved> curved_at(const Value& x, const Value& y)
  {
    const Value xx = x * x, yy = y * y, xy = x * y;
    std::array<Value, curved> terms;
    terms[isotropic - linear] = xx + yy;
    terms[difference - linear] = xx - yy;
    terms[mixed - linear] = xy + xy;
    if constexpr(Degree > 2)
    {
      std::array<Value, Degree + 1> power = {xx, xy, yy}; // all monomials of one degree
      for(int degree = 3, i = 3; degree <= Degree; ++degree)
      {
        power[degree] = y * power[degree - 1];
        for(int q = degree; q-- > 0;)
          power[q] = x * power[q];
        for(int q = 0; q <= degree; ++q)
          terms[i++] = power[q];
      }
    }
    return terms;
  }

  /// returns the mean square of the principal curvatures, given the coefficients of the quadratic terms.
  template <typename Coefficients>
  static auto squared_curvature(const Coefficients& c)
  {
    return 4 * (c[isotropic] * c[isotropic] + c[difference] * c[difference] + c[mixed] * c[mixed]);
  }

  /// returns the squares that let expect the coefficients of all terms above the quadratic ones to have. Along a line in
  /// any direction, cubic ones are of k^2 / 6, as if curvature changed by itself over its own radius, and quartic ones are
  /// of k^3 / 6: a third more than the circle z = k x^2 / 2 + k^3 x^4 / 8 + ... has, which does better with noise.
  /// What is expected is the same whichever way axes are turned: cos^3 and cos^4 of the angle between two directions tell
  /// how what is along one goes with what is along the other, hence the coefficients of these, as powers of sums or as
  /// sums of cosines of multiples.
  template <typename Scalar>
  static std::array<Scalar, size - quadratic> expected_squares(Scalar squared_curvature)
  {
    using Cubic = std::array<Scalar, 4>;
    using Quartic = std::array<Scalar, 5>;
    constexpr Cubic cubic = fitted > quadratic ? Cubic{1, 3, 3, 1} : Cubic{.75, .75, .25, .25};
    constexpr Quartic quartic = fitted == size ? Quartic{1, 4, 6, 4, 1} : Quartic{.375, .5, .5, .125, .125};
    const Scalar square_of_cubic = squared_curvature * squared_curvature / 36;
    const Scalar square_of_quartic = squared_curvature * squared_curvature * squared_curvature / 36;
    std::array<Scalar, size - quadratic> squares;
    for(std::size_t i = 0; i < cubic.size(); ++i)
      squares[i] = cubic[i] * square_of_cubic;
    for(std::size_t i = 0; i < quartic.size(); ++i)
      squares[cubic.size() + i] = quartic[i] * square_of_quartic;
    return squares;
  }

  /// returns the derivatives at a point, given the coefficients of the fitted terms; at the origin, the others have none.
  template <typename Coefficients, typename Scalar>
  static Derivatives<Scalar> derivatives_at(const Coefficients& c, Scalar x, Scalar y)
  {
    const Scalar xx = 2 * (c[isotropic] + c[difference]), xy = 2 * c[mixed], yy = 2 * (c[isotropic] - c[difference]);
    Derivatives<Scalar> d = {c[x_term] + xx * x + xy * y, c[y_term] + xy * x + yy * y, xx, xy, yy};
    const auto power = [](Scalar base, int exponent) {
      Scalar product = 1;
      while(exponent-- > 0)
        product *= base;
      return product;
    };
    for(int degree = 3, i = quadratic; degree <= Degree; ++degree)
      for(int q = 0, p = degree; q <= degree; ++q, --p, ++i)
      {
        d.x += c[i] * Scalar(p) * power(x, p - 1) * power(y, q);
        d.y += c[i] * Scalar(q) * power(x, p) * power(y, q - 1);
        d.xx += c[i] * Scalar(p * (p - 1)) * power(x, p - 2) * power(y, q);
        d.xy += c[i] * Scalar(p * q) * power(x, p - 1) * power(y, q - 1);
        d.yy += c[i] * Scalar(q * (q - 1)) * power(x, p) * power(y, q - 2);
      }
    return d;
  }

  /// returns the factor by which a linear or harmonic term depends on the direction with the given cosine and sine; the
  /// other one is a power of the distance.
  template <typename Value>
  static Value turning(int term, const Value& cosine, const Value& sine)
  {
    const Value cosine_of_2 = cosine * cosine - sine * sine, sine_of_2 = cosine * sine + cosine * sine;
    switch(term)
    {
      case x_term:
      case quadratic: return cosine;
      case y_term:
      case quadratic + 1: return sine;
      case quadratic + 2: return cosine * cosine_of_2 - sine * sine_of_2;
      case quadratic + 3: return cosine * sine_of_2 + sine * cosine_of_2;
      case quartic + 1: return cosine_of_2;
      case quartic + 2: return sine_of_2;
      case quartic + 3: return cosine_of_2 * cosine_of_2 - sine_of_2 * sine_of_2;
      case quartic + 4: return cosine_of_2 * sine_of_2 + cosine_of_2 * sine_of_2;
      default: return Value(1);
    }
  }
};

/// What a fit tells of the surface at the query point, in units of a length.
template <typename Scalar>
struct Local_field
{
  bool determined = false;
  bool is_whole = true; ///< no term had to be left out
  Derivatives<Scalar> derivatives;
  Scalar residual, standard_error, independent_values; ///< as in `Spider_fit`

  /// returns the same in units of a length, given this unit as a share of that.
  Local_field in_units_of(Scalar share) const
  {
    Local_field field = *this;
    for(Scalar* curvature : {&field.derivatives.xx, &field.derivatives.xy, &field.derivatives.yy, &field.standard_error})
      *curvature /= share;
    field.residual *= share;
    return field;
  }

  /// returns what is between this and another, in the same units, of which it has the given share. What isn't a number
  /// that both have is this one's.
  Local_field towards(const Local_field& other, Scalar share) const
  {
    const auto between = [=](Scalar from, Scalar to) { return from + share * (to - from); };
    const Derivatives<Scalar>&a = derivatives, &b = other.derivatives;
    Local_field field = *this;
    field.derivatives = {between(a.x, b.x), between(a.y, b.y), between(a.xx, b.xx), between(a.xy, b.xy),
                         between(a.yy, b.yy)};
    field.residual = between(residual, other.residual);
    field.standard_error = between(standard_error, other.standard_error);
    return field;
  }
};

/// returns the principal curvatures and directions of the graph of a height field at the origin, given its
/// derivatives there: from its fundamental forms in an orthonormal basis of its tangent plane.
template <typename Scalar>
Spider_fit<Scalar> principal_curvatures_of_graph(const Derivatives<Scalar>& z)
{
  Spider_fit<Scalar> fit;
  fit.normal = Vec3<Scalar>(-z.x, -z.y, 1).normalized();
  const Vec3<Scalar> u = Vec3<Scalar>(1, 0, z.x).normalized(), v = fit.normal.cross(u);
  const auto second_form = [&](const Vec3<Scalar>& a, const Vec3<Scalar>& b) { // positive away from the normal
    return -(a.x() * (z.xx * b.x() + z.xy * b.y()) + a.y() * (z.xy * b.x() + z.yy * b.y())) * fit.normal.z();
  };
  const Scalar uu = second_form(u, u), uv = second_form(u, v), vv = second_form(v, v);
  const Scalar mean = (uu + vv) / 2, difference = (uu - vv) / 2, deviation = std::hypot(difference, uv);
  fit.min_curvature = mean - deviation;
  fit.max_curvature = mean + deviation;
  const Scalar angle_of_max = std::atan2(uv, difference) / 2;
  fit.min_direction = std::sin(angle_of_max) * u - std::cos(angle_of_max) * v;
  fit.determined = std::isfinite(fit.min_curvature) && std::isfinite(fit.max_curvature);
  return fit;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_HEIGHT_FIELD_H
