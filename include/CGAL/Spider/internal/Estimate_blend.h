// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_ESTIMATE_BLEND_H
#define CGAL_SPIDER_INTERNAL_ESTIMATE_BLEND_H

#include <CGAL/Spider/Curvature_estimate_3.h>
#include <CGAL/Spider/internal/numbers.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace internal {

/// `Curvature_estimate_3` on plain numbers.
template <typename Scalar>
struct Estimate
{
  Scalar min_curvature = nan<Scalar>(), max_curvature = nan<Scalar>();
  Vec3<Scalar> min_direction = nan_vec3<Scalar>(), max_direction = nan_vec3<Scalar>(), normal = nan_vec3<Scalar>();
  Estimate_status status = isolated;
  Scalar coverage = 0;
  Scalar residual = nan<Scalar>();
  Scalar standard_error = nan<Scalar>(); ///< of mean curvature, where the estimator tells
  bool meets_border = false;             ///< a limb ended there

  bool has_fit() const { return status == ok || status == partial; }
};

/// returns a share that falls from 1, for values up to `from`, to 0, for values from `to` on; 0 for NaN.
template <typename Scalar>
Scalar falling(Scalar value, Scalar from, Scalar to)
{
  return value <= from ? Scalar(1) : value < to ? (to - value) / (to - from) : Scalar(0);
}

/// What is between several estimates of one point. Directions have no sign, and turn at once at an umbilic: so what is
/// averaged are the tensors in space that have the principal curvatures for eigenvalues.
template <typename Scalar>
class Estimate_blend
{
public:
  /// adds an estimate, if its share isn't 0. Shares are those of the rest that estimates added before left.
  void add(const Estimate<Scalar>& e, Scalar share)
  {
    if(share == 0)
      return;
    add_absolute(e, share * rest_);
    rest_ *= 1 - share;
  }

  /// returns the blend, given the estimate that gets the rest, if it has a fit.
  Estimate<Scalar> completed_by(const Estimate<Scalar>& last)
  {
    if(rest_ == 1)
      return last;
    if(last.has_fit())
      add_absolute(last, rest_);
    const Scalar all = last.has_fit() ? Scalar(1) : 1 - rest_;
    Estimate<Scalar> blend;
    blend.status = status_;
    blend.meets_border = meets_border_;
    blend.coverage = coverage_ / all;
    blend.residual = residual_ / all;
    blend.standard_error = standard_error_ / all;
    blend.normal = unit<Scalar>(normal_);
    find_principal_curvatures(all, blend);
    return blend;
  }

private:
  using Tensor = Eigen::Matrix<Scalar, 3, 3>;

  void add_absolute(const Estimate<Scalar>& e, Scalar share)
  {
    any_tangent_ = e.min_direction;
    shape_ += share * (e.min_curvature * e.min_direction * e.min_direction.transpose() +
                       e.max_curvature * e.max_direction * e.max_direction.transpose());
    normal_ += share * e.normal;
    coverage_ += share * e.coverage;
    residual_ += share * e.residual;
    standard_error_ += share * e.standard_error;
    status_ = status_ == ok ? e.status : status_;
    meets_border_ = meets_border_ || e.meets_border;
  }

  void find_principal_curvatures(Scalar sum_of_shares, Estimate<Scalar>& e) const
  {
    const Vec3<Scalar> u = unit<Scalar>(any_tangent_ - any_tangent_.dot(e.normal) * e.normal), v = e.normal.cross(u);
    const Scalar uu = u.dot(shape_ * u), uv = u.dot(shape_ * v), vv = v.dot(shape_ * v);
    const Scalar mean = (uu + vv) / 2, difference = (uu - vv) / 2, deviation = std::hypot(difference, uv);
    e.min_curvature = (mean - deviation) / sum_of_shares;
    e.max_curvature = (mean + deviation) / sum_of_shares;
    const Scalar angle_of_max = std::atan2(uv, difference) / 2;
    e.min_direction = unit<Scalar>(std::sin(angle_of_max) * u - std::cos(angle_of_max) * v);
    e.max_direction = e.normal.cross(e.min_direction);
  }

  Scalar rest_ = 1;
  Tensor shape_ = Tensor::Zero();
  Vec3<Scalar> normal_ = Vec3<Scalar>::Zero(), any_tangent_;
  Scalar coverage_ = 0, residual_ = 0, standard_error_ = 0;
  Estimate_status status_ = ok;
  bool meets_border_ = false;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_ESTIMATE_BLEND_H
