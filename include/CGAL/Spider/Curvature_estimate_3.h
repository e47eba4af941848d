// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_CURVATURE_ESTIMATE_3_H
#define CGAL_SPIDER_CURVATURE_ESTIMATE_3_H

#include <cmath>
#include <limits>
#include <ostream>

namespace CGAL {
namespace Spider {

/*!
\ingroup PkgSpiderClasses

Why an estimate is what it is.
*/
enum Estimate_status
{
  ok,           ///< every limb reached the radius
  partial,      ///< limbs ended early, but what is left determines a fit: values are given
  insufficient, ///< too little surface for a fit: curvatures are NaN, the normal is given if there is one
  isolated      ///< no incident face: everything is NaN
};

/// \ingroup PkgSpiderClasses
/// writes the name of a status.
inline std::ostream& operator<<(std::ostream& out, Estimate_status status)
{
  switch(status)
  {
    case ok: return out << "ok";
    case partial: return out << "partial";
    case insufficient: return out << "insufficient";
    default: return out << "isolated";
  }
}

/*!
\ingroup PkgSpiderClasses

The normal and the principal curvatures of a surface at one point.

Curvatures have the unit 1/length and are positive where the surface bends away from the normal: a sphere of radius
R with outward normals has both equal to 1/R. `(min_direction, max_direction, normal)` is a
right-handed orthonormal frame. Where there is no estimate the numbers are NaN and `status` says why.

\tparam GT a geometric traits class with a floating-point number type `FT` and `Vector_3`
*/
template <typename GT>
struct Curvature_estimate_3
{
  using FT = typename GT::FT;             ///< the number type
  using Vector_3 = typename GT::Vector_3; ///< the type of directions and of the normal

  /// returns what stands for a number that isn't known.
  static FT nan() { return std::numeric_limits<FT>::quiet_NaN(); }

  FT min_curvature = nan();                              ///< the smaller principal curvature, signed
  FT max_curvature = nan();                              ///< the larger principal curvature, signed
  Vector_3 min_direction = Vector_3(nan(), nan(), nan()); ///< unit tangent vector along which `min_curvature` is met
  Vector_3 max_direction = Vector_3(nan(), nan(), nan()); ///< unit tangent vector along which `max_curvature` is met
  Vector_3 normal = Vector_3(nan(), nan(), nan());        ///< unit normal, on the side to which the faces point
  Estimate_status status = isolated;                     ///< how the estimate came about
  FT coverage = FT(0);                                   ///< share in [0,1] of the full spider that its limbs reached
  FT residual = nan();                                   ///< root mean square distance of samples to the fit, a length

  /// is an estimate at an isolated vertex: nothing is known.
  Curvature_estimate_3() = default;

  /// converts from an estimate in another kernel.
  template <typename Other>
  explicit Curvature_estimate_3(const Curvature_estimate_3<Other>& other)
    : min_curvature(static_cast<FT>(other.min_curvature)), max_curvature(static_cast<FT>(other.max_curvature)),
      min_direction(convert(other.min_direction)), max_direction(convert(other.max_direction)),
      normal(convert(other.normal)), status(other.status), coverage(static_cast<FT>(other.coverage)),
      residual(static_cast<FT>(other.residual))
  {
  }

  /// returns H = (κ<sub>min</sub> + κ<sub>max</sub>) / 2, of the unit 1/length.
  FT mean_curvature() const { return (min_curvature + max_curvature) / FT(2); }

  /// returns K = κ<sub>min</sub> κ<sub>max</sub>, of the unit 1/length². H² ≥ K, since both come of
  /// the same two numbers.
  FT Gaussian_curvature() const { return min_curvature * max_curvature; }

  /// returns Koenderink's shape index in [-1,1]: 1 on a cap (as seen from the normal's side), 0.5 on a ridge, 0 on a
  /// symmetric saddle, -0.5 in a rut, -1 in a cup. It has no value, and is NaN, where the surface is flat.
  FT shape_index() const
  {
    const FT sum = max_curvature + min_curvature, difference = max_curvature - min_curvature;
    if(sum == FT(0) && difference == FT(0))
      return nan();
    const FT half_pi = std::acos(FT(0));
    return std::atan2(sum, difference) / half_pi;
  }

  /// returns Koenderink's curvedness √((κ<sub>min</sub>² + κ<sub>max</sub>²) / 2), of the unit 1/length.
  FT curvedness() const { return std::hypot(min_curvature, max_curvature) / std::sqrt(FT(2)); }

  /// tells whether the curvatures are given.
  bool is_valid() const { return status == ok || status == partial; }

private:
  template <typename Vector>
  static Vector_3 convert(const Vector& a)
  {
    return Vector_3(static_cast<FT>(a.x()), static_cast<FT>(a.y()), static_cast<FT>(a.z()));
  }
};

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_CURVATURE_ESTIMATE_3_H
