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

/// The place of x^p y^q in the order 1, x, y, x^2, xy, y^2, x^3, ...
constexpr int monomial(int p, int q)
{
  return number_of_monomials(p + q - 1) + q;
}

/// The terms of a height field z(x, y): the monomials up to a degree, which are fitted, and behind them the quartic
/// terms that these neglect at the expense of the second derivatives. On a disc those are the ones that turn with the
/// angle as x^2 + y^2, x^2 - y^2 and 2xy do; what turns otherwise is orthogonal to them.
template <int Degree>
struct Height_field_basis
{
  static constexpr int fitted = number_of_monomials(Degree);
  static constexpr int neglected = Degree < 4 ? 3 : 0;
  static constexpr int size = fitted + neglected;

  template <typename Scalar>
  static std::array<Scalar, size> at(Scalar x, Scalar y)
  {
    std::array<Scalar, size> row;
    row[0] = 1;
    for(int degree = 1, i = 1; degree <= Degree; ++degree)
    {
      for(int q = 0; q < degree; ++q, ++i)
        row[i] = x * row[i - degree];
      row[i] = y * row[i - degree - 1];
      ++i;
    }
    if constexpr(neglected > 0)
    {
      const Scalar squared_distance = x * x + y * y;
      row[fitted] = squared_distance * squared_distance;
      row[fitted + 1] = squared_distance * (x * x - y * y);
      row[fitted + 2] = squared_distance * 2 * x * y;
    }
    return row;
  }
};

/// returns the principal curvatures and directions of the graph of a height field at the origin, given its first and
/// second derivatives there: from its fundamental forms in an orthonormal basis of its tangent plane.
template <typename Scalar>
Spider_fit<Scalar> principal_curvatures_of_graph(Scalar zx, Scalar zy, Scalar zxx, Scalar zxy, Scalar zyy)
{
  Spider_fit<Scalar> fit;
  fit.normal = Vec3<Scalar>(-zx, -zy, 1).normalized();
  const Vec3<Scalar> u = Vec3<Scalar>(1, 0, zx).normalized(), v = fit.normal.cross(u);
  const auto second_form = [&](const Vec3<Scalar>& a, const Vec3<Scalar>& b) { // positive away from the normal
    return -(a.x() * (zxx * b.x() + zxy * b.y()) + a.y() * (zxy * b.x() + zyy * b.y())) * fit.normal.z();
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
