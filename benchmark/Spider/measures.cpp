// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measures.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

bool has_curvatures(const Estimate& e) { return std::isfinite(e.min_curvature) && std::isfinite(e.max_curvature); }
bool is_finite(const Vector& v) { return std::isfinite(v.squared_length()); }

// the angle between two directions in degrees; atan2 is exact near 0, where acos isn't
double angle(const Vector& u, const Vector& v)
{
  const double sine = std::sqrt(CGAL::cross_product(u, v).squared_length());
  return std::atan2(sine, u * v) * boost::math::constants::radian<double>();
}

// the same for lines, which have no sense: at most 90
double angle_of_lines(const Vector& u, const Vector& v)
{
  const double oriented = angle(u, v);
  return std::min(oriented, 180 - oriented);
}

// The errors of many vertices, each kind on a pile of its own.
class Error_piles
{
public:
  explicit Error_piles(double rms_curvature) : rms(rms_curvature) {}

  void add(const Estimate& estimate, const Estimate& reference)
  {
    ++errors.vertices;
    add_normal(estimate, reference);
    if(!has_curvatures(estimate))
    {
      ++errors.nan;
      return;
    }
    H.push_back(std::abs(estimate.mean_curvature() - reference.mean_curvature()) / rms);
    K.push_back(std::abs(estimate.Gaussian_curvature() - reference.Gaussian_curvature()) / (rms * rms));
    min_curvature.push_back(std::abs(estimate.min_curvature - reference.min_curvature) / rms);
    max_curvature.push_back(std::abs(estimate.max_curvature - reference.max_curvature) / rms);
    errors.wild += H.back() > wild_error;
    add_direction(estimate, reference);
  }

  Errors summary()
  {
    errors.H = summarise(H);
    errors.K = summarise(K);
    errors.min_curvature = summarise(min_curvature);
    errors.max_curvature = summarise(max_curvature);
    errors.direction = summarise(direction);
    errors.normal = summarise(normal);
    return errors;
  }

private:
  void add_normal(const Estimate& estimate, const Estimate& reference)
  {
    if(is_finite(estimate.normal) && is_finite(reference.normal))
      normal.push_back(angle(estimate.normal, reference.normal));
  }

  void add_direction(const Estimate& estimate, const Estimate& reference)
  {
    const bool defined = reference.max_curvature - reference.min_curvature > umbilic_difference * rms;
    if(defined && is_finite(estimate.max_direction) && is_finite(reference.max_direction))
      direction.push_back(angle_of_lines(estimate.max_direction, reference.max_direction));
  }

  double rms;
  Errors errors;
  std::vector<double> H, K, min_curvature, max_curvature, direction, normal;
};

} // namespace

Summary summarise(std::vector<double>& errors)
{
  if(errors.empty())
    return {Estimate::nan, Estimate::nan, Estimate::nan, Estimate::nan};
  std::sort(errors.begin(), errors.end());
  const double count = static_cast<double>(errors.size());
  const auto quantile = [&](double share) { return errors[static_cast<std::size_t>(share * (count - 1))]; };
  return {std::accumulate(errors.begin(), errors.end(), 0.) / count, quantile(0.5), quantile(0.95), errors.back()};
}

Errors compare(const std::vector<Estimate>& estimates, const std::vector<Estimate>& reference,
               const std::vector<Mesh::Vertex_index>& vertices, double rms_curvature)
{
  Error_piles piles(rms_curvature);
  for(auto v : vertices)
    if(has_curvatures(reference[v]))
      piles.add(estimates[v], reference[v]);
  return piles.summary();
}

std::vector<Mesh::Vertex_index> interior_vertices(const Surface& surface, double margin)
{
  std::vector<Mesh::Vertex_index> interior;
  for(auto v : surface.mesh.vertices())
    if(surface.border_distance[v] > margin)
      interior.push_back(v);
  return interior;
}

std::vector<Errors> compare_by_border_distance(const std::vector<Estimate>& estimates, const Surface& surface,
                                               double radius)
{
  std::vector<Errors> bins;
  double from = -1; // the border's own vertices belong to the first bin
  for(const double to : border_bins)
  {
    std::vector<Mesh::Vertex_index> members;
    for(auto v : surface.mesh.vertices())
    {
      const double distance = surface.border_distance[v] / radius;
      if(from < distance && distance <= to)
        members.push_back(v);
    }
    bins.push_back(compare(estimates, surface.truth, members, surface.rms_curvature));
    from = to;
  }
  const auto is_empty = [](const Errors& bin) { return bin.vertices == 0; };
  return std::all_of(bins.begin(), bins.end(), is_empty) ? std::vector<Errors>() : bins;
}

double robust_rms_curvature(const std::vector<Estimate>& estimates)
{
  constexpr double left_out = 0.01;
  std::vector<double> squares;
  for(const Estimate& e : estimates)
    if(has_curvatures(e))
      squares.push_back((e.min_curvature * e.min_curvature + e.max_curvature * e.max_curvature) / 2);
  if(squares.empty())
    return Estimate::nan;
  std::sort(squares.begin(), squares.end());
  const auto skipped = static_cast<std::ptrdiff_t>(left_out * static_cast<double>(squares.size()));
  const auto first = squares.begin() + skipped, last = squares.end() - skipped;
  return std::sqrt(std::accumulate(first, last, 0.) / static_cast<double>(last - first));
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
