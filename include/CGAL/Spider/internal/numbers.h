// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What Spider computes in, and how the caller's numbers, points and vectors are carried over and back.

#ifndef CGAL_SPIDER_INTERNAL_NUMBERS_H
#define CGAL_SPIDER_INTERNAL_NUMBERS_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Spider {
namespace internal {

/// The number type of all computation: `double`, or the caller's own floating type where that is wider.
template <typename FT>
using Scalar_for = std::conditional_t<std::is_same<FT, long double>::value, long double, double>;

/// The kernel of results: the caller's, unless its numbers aren't floating-point.
template <typename GT>
using Result_kernel =
  std::conditional_t<std::is_floating_point<typename GT::FT>::value, GT, CGAL::Simple_cartesian<double>>;

template <typename TriangleMesh>
using Result_kernel_of_mesh = Result_kernel<typename CGAL::Kernel_traits<typename boost::property_traits<
  typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>::value_type>::Kernel>;

template <typename Scalar>
using Vec3 = Eigen::Matrix<Scalar, 3, 1>;

template <typename Scalar, typename FT>
Scalar to_scalar(const FT& x)
{
  if constexpr(std::is_arithmetic<FT>::value)
    return static_cast<Scalar>(x);
  else
    return static_cast<Scalar>(CGAL::to_double(x));
}

/// carries a point or vector of any kernel over.
template <typename Scalar, typename Triple>
Vec3<Scalar> to_vec3(const Triple& a)
{
  return {to_scalar<Scalar>(a.x()), to_scalar<Scalar>(a.y()), to_scalar<Scalar>(a.z())};
}

/// carries a vector back into a point or vector of the results' kernel.
template <typename Triple, typename Scalar>
Triple from_vec3(const Vec3<Scalar>& a)
{
  using FT = typename CGAL::Kernel_traits<Triple>::Kernel::FT;
  return Triple(static_cast<FT>(a.x()), static_cast<FT>(a.y()), static_cast<FT>(a.z()));
}

template <typename Scalar>
constexpr Scalar nan()
{
  return std::numeric_limits<Scalar>::quiet_NaN();
}

template <typename Scalar>
Vec3<Scalar> nan_vec3()
{
  return Vec3<Scalar>::Constant(nan<Scalar>());
}

/// normalizes without overflow or underflow; a vector without a direction becomes NaN.
template <typename Scalar>
Vec3<Scalar> unit(const Vec3<Scalar>& a)
{
  const Scalar largest = a.template lpNorm<Eigen::Infinity>();
  if(!(largest > 0) || !std::isfinite(largest))
    return nan_vec3<Scalar>();
  const Vec3<Scalar> scaled = a / largest;
  return scaled / scaled.norm();
}

/// returns the angle between two unit vectors, exact for small angles where the arc cosine isn't.
template <typename Scalar>
Scalar angle_between(const Vec3<Scalar>& a, const Vec3<Scalar>& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

template <typename Scalar>
Scalar power_of_two_at_most(Scalar positive)
{
  return std::scalbn(Scalar(1), std::ilogb(positive));
}

/// returns a share that falls from 1, for values up to `from`, to 0, for values from `to` on; 0 for NaN.
template <typename Scalar>
Scalar falling(Scalar value, Scalar from, Scalar to)
{
  return value <= from ? Scalar(1) : value < to ? (to - value) / (to - from) : Scalar(0);
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_NUMBERS_H
