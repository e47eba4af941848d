// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_ESTIMATE_BLEND_H
#define CGAL_SPIDER_INTERNAL_ESTIMATE_BLEND_H

#include <CGAL/Spider/Curvature_estimate_3.h>
#include <CGAL/Spider/internal/Spider_frame.h>
#include <CGAL/Spider/internal/numbers.h>

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

/// returns the tensor in space that tells how normal curvature differs from mean curvature by direction, in units of
/// half of what the principal curvatures differ by. Directions have no sign in it.
template <typename Scalar>
Eigen::Matrix<Scalar, 3, 3> directions_tensor(const Estimate<Scalar>& e)
{
  return e.max_direction * e.max_direction.transpose() - e.min_direction * e.min_direction.transpose();
}

/// What is between several estimates of one point. Directions have no sign, and turn at once at an umbilic: so what is
/// averaged, besides mean curvature, are the tensors in space that tell how curvature differs from it by direction.
template <typename Scalar>
class Estimate_blend
{
public:
  /// adds an estimate, with a share of what estimates added before left.
  void add(const Estimate<Scalar>& e, Scalar share)
  {
    if(share == 0)
      return;
    const Scalar share_of_all = share * rest_;
    rest_ *= 1 - share;
    mean_curvature_ += share_of_all * (e.min_curvature + e.max_curvature) / 2;
    differences_ += share_of_all * (e.max_curvature - e.min_curvature) / 2 * directions_tensor(e);
    normal_ += share_of_all * e.normal;
    coverage_ += share_of_all * e.coverage;
    residual_ += share_of_all * e.residual;
    standard_error_ += share_of_all * e.standard_error;
    status_ = status_ == ok ? e.status : status_;
    meets_border_ = meets_border_ || e.meets_border;
  }

  /// returns the blend, given the estimate that gets what is left.
  Estimate<Scalar> completed_by(const Estimate<Scalar>& last)
  {
    if(rest_ == 1)
      return last;
    add(last, 1);
    Estimate<Scalar> blend;
    blend.status = status_;
    blend.meets_border = meets_border_;
    blend.coverage = coverage_;
    blend.residual = residual_;
    blend.standard_error = standard_error_;
    blend.normal = unit<Scalar>(normal_);
    find_principal_curvatures(Spider_frame<Scalar>(blend.normal, last.min_direction), blend);
    return blend;
  }

private:
  void find_principal_curvatures(const Spider_frame<Scalar>& frame, Estimate<Scalar>& e) const
  {
    const Vec3<Scalar>&u = frame.tangent, &v = frame.bitangent;
    const Scalar difference = (u.dot(differences_ * u) - v.dot(differences_ * v)) / 2, mixed = u.dot(differences_ * v);
    const Scalar deviation = std::hypot(difference, mixed), angle_of_max = std::atan2(mixed, difference) / 2;
    e.min_curvature = mean_curvature_ - deviation;
    e.max_curvature = mean_curvature_ + deviation;
    e.min_direction = unit<Scalar>(std::sin(angle_of_max) * u - std::cos(angle_of_max) * v);
    e.max_direction = e.normal.cross(e.min_direction);
  }

  Scalar rest_ = 1;
  Scalar mean_curvature_ = 0;
  Eigen::Matrix<Scalar, 3, 3> differences_ = Eigen::Matrix<Scalar, 3, 3>::Zero();
  Vec3<Scalar> normal_ = Vec3<Scalar>::Zero();
  Scalar coverage_ = 0, residual_ = 0, standard_error_ = 0;
  Estimate_status status_ = ok;
  bool meets_border_ = false;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_ESTIMATE_BLEND_H
