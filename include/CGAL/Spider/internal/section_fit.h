// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The estimator as published: one polynomial per direction (paper, 2.2), then the orthogonal pair of directions whose
// curvatures differ most (paper, 2.3).

#ifndef CGAL_SPIDER_INTERNAL_SECTION_FIT_H
#define CGAL_SPIDER_INTERNAL_SECTION_FIT_H

#include <CGAL/Spider/internal/Samples.h>
#include <CGAL/Spider/internal/Spider_frame.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

constexpr int max_polynomial_degree = 4;

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
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, 0, max_polynomial_degree, max_polynomial_degree>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1, 0, max_polynomial_degree, 1>;

  Section<Scalar> section;
  section.number_of_samples = samples.size();
  if(static_cast<int>(samples.size()) < degree)
    return section;

  Matrix normal_matrix = Matrix::Zero(degree, degree);
  Vector right_side = Vector::Zero(degree), powers(degree);
  normal_matrix(0, 0) = 1; // the tangent's equation
  for(const Sample<Scalar>& sample : samples)
  {
    powers[0] = sample.y;
    for(int k = 1; k < degree; ++k)
      powers[k] = powers[k - 1] * sample.y;
    normal_matrix += powers * powers.transpose();
    right_side += sample.z * powers;
  }

  // With a unit diagonal, a pivot is the share of a power that the lower powers don't explain on these samples.
  const Vector scale = normal_matrix.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::LDLT<Matrix> factorization(scale.asDiagonal() * normal_matrix * scale.asDiagonal());
  constexpr Scalar least_pivot = Scalar(1e-10); // below, rounding has eaten half of the digits of a quartic
  if(!scale.allFinite() || !(factorization.vectorD().minCoeff() > least_pivot))
    return section;
  const Vector coefficients = scale.cwiseProduct(factorization.solve(scale.cwiseProduct(right_side)));
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

/// What an estimator makes of one spider, in its frame and in units of the radius.
template <typename Scalar>
struct Spider_fit
{
  bool determined = false;
  Scalar min_curvature = nan<Scalar>(), max_curvature = nan<Scalar>();
  Scalar min_angle = nan<Scalar>();  ///< of the direction of `min_curvature`; that of `max_curvature` is a quarter turn on
  Vec3<Scalar> normal = nan_vec3<Scalar>(); ///< the new normal in the coordinates (tangent, bitangent, normal)
  Scalar residual = nan<Scalar>();          ///< root mean square
};

/// returns the normal of a section along a unit tangent: the tangent of the section has the given slope.
template <typename Scalar>
Vec3<Scalar> section_normal(Scalar angle, Scalar slope)
{
  return Vec3<Scalar>(-slope * std::cos(angle), -slope * std::sin(angle), 1).normalized();
}

/// finds the orthogonal pair of greatest difference among the sections along an even number of directions that are
/// spaced regularly over a half turn; the new normal is the average of the normals of the two (paper, 2.3).
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
  fit.min_angle = angle_of_direction<Scalar>(least, count);

  // At the tip of a cube three pairs tie. One pair stands for directions up to a spacing away, where by Euler's theorem
  // the difference falls by the cosine of twice that: pairs that near to the greatest share in the normal.
  const Scalar as_great = std::cos(2 * angle_of_direction<Scalar>(1, count)) * std::abs(difference(principal));
  Vec3<Scalar> normal = Vec3<Scalar>::Zero();
  for(int i = 0; i < quarter; ++i)
    if(std::abs(difference(i)) >= as_great)
      for(int k : {i, i + quarter})
        normal += section_normal(angle_of_direction<Scalar>(k, count), sections[k].slope);
  fit.normal = normal.normalized();

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

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SECTION_FIT_H
