// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The estimator as published: one polynomial per direction (paper, 2.2), then the orthogonal pair of directions whose
// curvatures differ most (paper, 2.3).

#ifndef CGAL_SPIDER_INTERNAL_SECTION_FIT_H
#define CGAL_SPIDER_INTERNAL_SECTION_FIT_H

#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Samples.h>
#include <CGAL/Spider/internal/Spider_fit.h>
#include <CGAL/Spider/internal/Spider_frame.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// walks the two limbs of a direction and collects their samples, in the coordinates of the direction.
template <typename View>
void sample_direction(const View& view,
                      const Site<View>& site,
                      const Local_coordinates<typename View::Scalar>& local,
                      typename View::Scalar angle,
                      const Options<typename View::Scalar>& options,
                      std::vector<Sample<typename View::Scalar>>& samples,
                      Spider_extent<typename View::Scalar>& extent)
{
  using Scalar = typename View::Scalar;
  samples.clear();
  for(int sign : {1, -1})
  {
    const Cut<Scalar> cut(local, sign * std::cos(angle), sign * std::sin(angle));
    const Walk_result<View> walk =
      sample_limb(view, site, cut, options.limb_rule, options.resampling_step, sign, samples);
    extent.add(walk.reached, walk.end);
  }
}

/// The section of the surface along one direction, in units of the radius.
template <typename Scalar>
struct Section
{
  bool determined = false;
  Scalar slope = nan<Scalar>();     ///< of the tangent at the query point
  Scalar curvature = nan<Scalar>(); ///< at the query point, positive where the section bends away from the normal
  Scalar squared_residuals = 0;     ///< summed over the samples
  std::size_t number_of_samples = 0;
};

/// fits z = c1 y + ... + ck y^k, which passes through the query point, with the further equation c1 = 0 in the least
/// squares, which pulls the tangent towards the direction (paper, 2.2).
template <typename Scalar>
Section<Scalar> fit_section(const std::vector<Sample<Scalar>>& samples, int degree)
{
  Section<Scalar> section;
  section.number_of_samples = samples.size();
  if(static_cast<int>(samples.size()) < degree)
    return section;

  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, 0, max_polynomial_degree, max_polynomial_degree>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1, 0, max_polynomial_degree, 1>;
  Matrix normal_matrix = Matrix::Zero(degree, degree);
  Vector right_side = Vector::Zero(degree), powers(degree);
  normal_matrix(0, 0) = 1; // the tangent's equation
  for(const Sample<Scalar>& sample : samples)
  {
    powers[0] = sample.y;
    for(int k = 1; k < degree; ++k)
      powers[k] = powers[k - 1] * sample.y;
    for(int i = 0; i < degree; ++i)
    {
      for(int k = 0; k < degree; ++k)
        normal_matrix(i, k) += powers[i] * powers[k];
      right_side[i] += sample.z * powers[i];
    }
  }

  const Vector scale = normal_matrix.diagonal().cwiseSqrt().cwiseInverse();
  for(int i = 0; i < degree; ++i)
    for(int k = 0; k < degree; ++k)
      normal_matrix(i, k) *= scale[i] * scale[k];
  constexpr Scalar least_pivot = Scalar(1e-10); // below, rounding has eaten half of the digits of a quartic
  // With a unit diagonal, a pivot is the share of a power that the lower powers don't explain on these samples.
  const Eigen::LDLT<Matrix> factorization(normal_matrix);
  for(int i = 0; i < degree; ++i)
    if(!(factorization.vectorD()[i] > least_pivot))
      return section;
  const Vector scaled_right_side = scale.cwiseProduct(right_side);
  const Vector coefficients = scale.cwiseProduct(factorization.solve(scaled_right_side));
  if(!coefficients.allFinite())
    return section;

  for(const Sample<Scalar>& sample : samples)
  {
    Scalar z = 0;
    for(int k = degree; k-- > 0;)
      z = (z + coefficients[k]) * sample.y;
    section.squared_residuals += (sample.z - z) * (sample.z - z);
  }
  section.determined = true;
  section.slope = coefficients[0];
  section.curvature = -2 * coefficients[1] / std::pow(1 + section.slope * section.slope, Scalar(1.5));
  return section;
}

/// returns the normal of a section along a unit tangent: the tangent of the section has the given slope.
template <typename Scalar>
Vec3<Scalar> section_normal(Scalar angle, Scalar slope)
{
  return Vec3<Scalar>(-slope * std::cos(angle), -slope * std::sin(angle), 1).normalized();
}

/// turns a tangent along with the normal, which goes from the frame's to `normal` by the smallest rotation. Unlike a
/// projection it treats both directions of a pair alike.
template <typename Scalar>
Vec3<Scalar> turned_along(const Vec3<Scalar>& tangent, const Vec3<Scalar>& normal)
{
  return tangent - normal.dot(tangent) / (1 + normal.z()) * (normal + Vec3<Scalar>::UnitZ());
}

/// finds the orthogonal pair of greatest difference among the sections along an even number of directions that are
/// spaced regularly over a half turn; the new normal is the average of their normals (paper, 2.3) and of those of the
/// pairs that are nearly as great.
template <typename Scalar>
Spider_fit<Scalar> fit_principal_pair(const std::vector<Section<Scalar>>& sections)
{
  const int count = static_cast<int>(sections.size()), quarter = count / 2;
  const auto difference = [&](int i) { return sections[i + quarter].curvature - sections[i].curvature; };
  int principal = 0;
  for(int i = 1; i < quarter; ++i)
    if(!(std::abs(difference(principal)) >= std::abs(difference(i)))) // also where the one is undetermined, thus NaN
      principal = std::isnan(difference(i)) ? principal : i;

  Spider_fit<Scalar> fit;
  if(std::isnan(difference(principal)))
    return fit;
  fit.determined = true;
  const bool in_order = difference(principal) >= 0;
  const int least = in_order ? principal : principal + quarter, greatest = in_order ? principal + quarter : principal;
  fit.min_curvature = sections[least].curvature;
  fit.max_curvature = sections[greatest].curvature;
  const Scalar angle = angle_of_direction<Scalar>(least, count);

  // Where the surface is smooth all pairs lead to the same normal. Where it isn't, as at the tip of a cube, far apart
  // pairs nearly tie, and the greatest alone would leave the normal to chance: by Euler's theorem the difference falls
  // by the cosine of twice the angle, so half of the pairs are as great as this, and share in the normal.
  const Scalar as_great = std::sqrt(Scalar(0.5)) * std::abs(difference(principal));
  Vec3<Scalar> normal = Vec3<Scalar>::Zero();
  for(int i = 0; i < quarter; ++i)
    if(std::abs(difference(i)) >= as_great)
      for(int k : {i, i + quarter})
        normal += section_normal(angle_of_direction<Scalar>(k, count), sections[k].slope);
  fit.normal = normal.normalized();
  fit.min_direction = turned_along(Vec3<Scalar>(std::cos(angle), std::sin(angle), 0), fit.normal);

  Scalar squared_residuals = 0;
  std::size_t number_of_samples = 0;
  for(const Section<Scalar>& section : sections)
    if(section.determined)
    {
      squared_residuals += section.squared_residuals;
      number_of_samples += section.number_of_samples;
    }
  fit.residual = std::sqrt(squared_residuals / Scalar(number_of_samples));
  return fit;
}

/// `section_fit`, the estimator as published.
template <typename View>
class Section_fit
{
  using Scalar = typename View::Scalar;

public:
  static constexpr bool rests_at_best_fit = false; ///< but where the normal does (paper, 2.4)
  static constexpr bool walks_once_for_all_radii = false;

  explicit Section_fit(const Options<Scalar>& options) : options_(options) {}

  /// grows a spider and fits it.
  Spider_fit<Scalar> operator()(const View& view,
                                const Site<View>& site,
                                const Spider_frame<Scalar>& frame,
                                Scalar radius,
                                Spider_extent<Scalar>& extent)
  {
    const int count = options_.number_of_directions_at(radius);
    sections_.clear();
    const Local_coordinates<Scalar> local(site.point, frame, radius);
    for(int i = 0; i < count; ++i)
    {
      sample_direction(view, site, local, angle_of_direction<Scalar>(i, count), options_, samples_, extent);
      sections_.push_back(fit_section(samples_, options_.polynomial_degree));
    }
    return fit_principal_pair(sections_);
  }

private:
  const Options<Scalar>& options_;
  std::vector<Sample<Scalar>> samples_;
  std::vector<Section<Scalar>> sections_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SECTION_FIT_H
