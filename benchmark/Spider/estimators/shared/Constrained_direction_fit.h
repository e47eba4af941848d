// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_SHARED_CONSTRAINED_DIRECTION_FIT_H
#define CGAL_SPIDER_BENCHMARK_SHARED_CONSTRAINED_DIRECTION_FIT_H

#include "tangent_tensor.h"

#include <algorithm>

namespace CGAL {
namespace Spider {
namespace benchmark {

// Finds the principal directions from normal curvatures along edges where H and K are given (Meyer et al. 2003,
// section 5.3). The normal curvature at angle t is H + x cos 2t + y sin 2t, where (x, y) has the length
// D = sqrt(H^2 - K) and the angle 2 phi, phi being the direction of the greater curvature. So what is sought is the
// (x, y) on the circle of radius D that is nearest to the edges' values in weighted least squares.
class Constrained_direction_fit
{
public:
  // an edge vector from the vertex, its weight, and the mean curvature that is given
  void add(const Tangent_frame& frame, const Vector& edge, double weight, double mean_curvature)
  {
    const double x = edge * frame.u, y = edge * frame.v, squared = x * x + y * y;
    if(!(squared > 0))
      return; // the edge is along the normal
    const double normal_curvature = -2 * (edge * frame.normal) / edge.squared_length();
    const double cosine = (x * x - y * y) / squared, sine = 2 * x * y / squared;
    const double value = normal_curvature - mean_curvature;
    m_cc += weight * cosine * cosine;
    m_cs += weight * cosine * sine;
    m_ss += weight * sine * sine;
    m_cv += weight * cosine * value;
    m_sv += weight * sine * value;
  }

  // the angle phi, from the frame's u towards its v
  double angle(double deviation) const
  {
    // minimise z'Az - 2 b'z on the circle, in the eigenvectors of A: z = b / (eigenvalue + multiplier)
    const double mean = (m_cc + m_ss) / 2, half = (m_cc - m_ss) / 2, gap = 2 * std::hypot(half, m_cs);
    const double axis = std::atan2(m_cs, half) / 2, cosine = std::cos(axis), sine = std::sin(axis);
    const double b_large = cosine * m_cv + sine * m_sv, b_small = -sine * m_cv + cosine * m_sv;
    if(!std::isfinite(mean + b_large + b_small + deviation))
      return Estimate::nan;

    double large = 1, small = 0; // any direction will do where the curvatures are equal
    if(deviation > 0)
      minimise_on_circle(gap, b_large, b_small, deviation, large, small);
    return std::atan2(sine * large + cosine * small, cosine * large - sine * small) / 2;
  }

private:
  // The multiplier is measured from the lesser eigenvalue's negative, so that it is positive and the eigenvalues become
  // 0 and `gap`. Newton's iteration on 1/length, which is almost linear in the multiplier, climbs from the left.
  static void minimise_on_circle(double gap, double b_large, double b_small, double radius, double& large,
                                 double& small)
  {
    constexpr int most_rounds = 100; // 3 to 5 are usual, 40 where b_small is rounding and the circle meets the optimum
    constexpr double precision = 1e-14; // of the length
    double multiplier = (std::max)(std::abs(b_small) / radius, std::abs(b_large) / radius - gap);
    if(!(multiplier > 0))
    {
      // no component along the lesser eigenvector: either sign of it is as good
      large = gap > 0 ? b_large / gap : radius;
      small = std::sqrt((std::max)(0., radius * radius - large * large));
      return;
    }
    for(int round = 0; round < most_rounds; ++round)
    {
      large = b_large / (gap + multiplier);
      small = b_small / multiplier;
      const double squared = large * large + small * small, length = std::sqrt(squared);
      if(length - radius <= precision * radius)
        return;
      const double slope = large * large / (gap + multiplier) + small * small / multiplier;
      multiplier += squared / slope * (length - radius) / radius;
    }
  }

  double m_cc = 0, m_cs = 0, m_ss = 0, m_cv = 0, m_sv = 0;
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_SHARED_CONSTRAINED_DIRECTION_FIT_H
