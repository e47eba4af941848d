// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the tests of estimation share: the settings that every promise is held to, and comparisons.

#ifndef CGAL_SPIDER_TEST_ESTIMATION_H
#define CGAL_SPIDER_TEST_ESTIMATION_H

#include "meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/Curvature_estimator.h>
#include <CGAL/Spider/parameters.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace estimation {

namespace Spider = CGAL::Spider;
namespace params = CGAL::Spider::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Estimate = Spider::Curvature_estimate_3<Kernel>;
using meshes::Vector;
using meshes::vector;

/// calls `body` with each of the settings for which the package makes its promises. `radius` may be a property map.
template <typename Radius, typename Body>
void for_each_setting(const Radius& radius, Body&& body)
{
  {
    SCOPED_TRACE("as published");
    body(params::as_published().geodesic_radius(radius));
  }
  {
    SCOPED_TRACE("default parameters");
    body(params::geodesic_radius(radius));
  }
}

/// returns the estimates at all vertices, or at every `stride`th, in their order and in `Kernel`.
template <typename AnyMesh, typename NamedParameters>
std::vector<Estimate> estimates(const AnyMesh& mesh, const NamedParameters& np, std::size_t stride = 1)
{
  const Spider::Curvature_estimator<AnyMesh, NamedParameters> estimator(mesh, np);
  std::vector<Estimate> result;
  std::size_t number = 0;
  for(auto v : vertices(mesh))
    if(number++ % stride == 0)
      result.push_back(Estimate(estimator(v)));
  return result;
}

/// A mesh without its connectivity, its vertices numbered from zero in their order.
struct Soup
{
  std::vector<Vector> points;
  std::vector<meshes::Triangle> triangles;
};

inline Soup soup_of(const Mesh& mesh)
{
  Soup soup;
  std::map<Vertex, std::size_t> numbers;
  for(Vertex v : mesh.vertices())
  {
    numbers[v] = soup.points.size();
    soup.points.push_back(meshes::point(mesh, v));
  }
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    soup.triangles.push_back({numbers[mesh.source(h)], numbers[mesh.target(h)], numbers[mesh.target(mesh.next(h))]});
  }
  return soup;
}

/// returns irregular and noisy meshes: closed, with a handle, and with a border. Edges are around 0.15 long.
inline std::vector<std::pair<std::string, Mesh>> irregular_noisy_meshes()
{
  return {{"sphere", meshes::jittered(meshes::icosphere<Mesh>(3), 0.03, 1)},
          {"torus", meshes::jittered(meshes::torus<Mesh>(1, 0.4, 40, 16), 0.03, 2)},
          {"saddle", meshes::jittered(meshes::saddle<Mesh>(10, 0.1, 1.5, -0.5, meshes::alternating), 0.02, 3)}};
}

inline bool is_finite(const Estimate& e)
{
  return std::isfinite(e.min_curvature) && std::isfinite(e.max_curvature) && vector(e.min_direction).allFinite() &&
         vector(e.max_direction).allFinite() && vector(e.normal).allFinite() && std::isfinite(e.residual) &&
         std::isfinite(e.coverage);
}

/// expects what every estimate promises, whatever the mesh.
inline void expect_sound(const Estimate& e)
{
  EXPECT_GE(e.coverage, 0);
  EXPECT_LE(e.coverage, 1 + 1e-12);
  if(!e.is_valid())
  {
    EXPECT_TRUE(std::isnan(e.min_curvature) && std::isnan(e.max_curvature) && std::isnan(e.residual));
    EXPECT_TRUE(vector(e.min_direction).array().isNaN().all() && vector(e.max_direction).array().isNaN().all());
    return;
  }
  EXPECT_TRUE(is_finite(e));
  EXPECT_LE(e.min_curvature, e.max_curvature);
  EXPECT_GE(e.residual, 0);
  Eigen::Matrix3d frame;
  frame << vector(e.min_direction), vector(e.max_direction), vector(e.normal);
  EXPECT_TRUE((frame.transpose() * frame).isIdentity(1e-12)) << frame;
  EXPECT_NEAR(frame.determinant(), 1, 1e-12);
}

/// returns the angle between two vectors.
inline double angle(const Vector& a, const Vector& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// returns the angle between two lines.
inline double angle_of_lines(const Vector& a, const Vector& b) { return std::min(angle(a, b), angle(a, -b)); }

/// to the last bit
inline void expect_same(const Estimate& a, const Estimate& b)
{
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.coverage, b.coverage);
  EXPECT_EQ(a.min_curvature, b.min_curvature);
  EXPECT_EQ(a.max_curvature, b.max_curvature);
  EXPECT_EQ(a.residual, b.residual);
  EXPECT_EQ(a.normal, b.normal);
}

/// expects two estimates to be the same up to rounding; `tolerance` is relative to the larger curvature, and absolute
/// for what has no unit.
inline void expect_same(const Estimate& a, const Estimate& b, double tolerance)
{
  EXPECT_EQ(a.status, b.status);
  EXPECT_NEAR(a.coverage, b.coverage, tolerance);
  EXPECT_EQ(std::isnan(vector(a.normal).sum()), std::isnan(vector(b.normal).sum()));
  if(vector(a.normal).allFinite())
  {
    EXPECT_LE(angle(vector(a.normal), vector(b.normal)), tolerance);
  }
  if(!a.is_valid() || !b.is_valid())
    return;
  const double size = std::max(std::abs(a.min_curvature), std::abs(a.max_curvature));
  EXPECT_NEAR(a.min_curvature, b.min_curvature, tolerance * size);
  EXPECT_NEAR(a.max_curvature, b.max_curvature, tolerance * size);
  EXPECT_NEAR(a.residual, b.residual, tolerance * (a.residual + 1 / size));
  const double turn = tolerance * size / (a.max_curvature - a.min_curvature); // directions are lost at an umbilic
  EXPECT_LE(angle_of_lines(vector(a.min_direction), vector(b.min_direction)), turn);
  EXPECT_LE(angle_of_lines(vector(a.max_direction), vector(b.max_direction)), turn);
}

/// expects two estimates to be the same to the last bit, NaN included.
inline void expect_identical(const Estimate& a, const Estimate& b)
{
  const auto numbers = [](const Estimate& e) {
    return std::vector<double>{e.min_curvature,     e.max_curvature,     e.min_direction.x(), e.min_direction.y(),
                               e.min_direction.z(), e.max_direction.x(), e.max_direction.y(), e.max_direction.z(),
                               e.normal.x(),        e.normal.y(),        e.normal.z(),        e.coverage,
                               e.residual};
  };
  EXPECT_EQ(a.status, b.status);
  const std::vector<double> of_a = numbers(a), of_b = numbers(b);
  for(std::size_t i = 0; i < of_a.size(); ++i)
    EXPECT_TRUE(of_a[i] == of_b[i] || (std::isnan(of_a[i]) && std::isnan(of_b[i]))) << of_a[i] << ", " << of_b[i];
}

/// returns the value below which a share of the values lies.
inline double quantile(std::vector<double> values, double share)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// A section of a surface by a plane, given exactly: `curve(t)` is the point (y, z) with the query point (0, 0) at t =
/// 0. Returns the samples at `per_limb` regular arc lengths up to `radius` on either side, in units of the radius.
template <typename Curve>
std::vector<Eigen::Vector2d> sample_section(Curve&& curve, double radius, int per_limb = 10)
{
  constexpr double fine = 1e-5; // steps of t so small that a chord is as long as its arc to 1e-11
  std::vector<Eigen::Vector2d> samples;
  for(int sign : {1, -1})
  {
    Eigen::Vector2d last(0, 0);
    double length = 0;
    for(int i = 1, count = 1; count <= per_limb; ++i)
    {
      const Eigen::Vector2d next = curve(sign * fine * i);
      const double step = (next - last).norm(), wanted = count * radius / per_limb;
      if(length + step >= wanted)
      {
        samples.push_back((last + (wanted - length) / step * (next - last)) / radius);
        ++count;
      }
      length += step;
      last = next;
    }
  }
  return samples;
}

/// What the paper's fit of one section yields, in units of the radius.
struct Section_fit
{
  double curvature, slope, residual;
};

/// fits the paper's polynomial, which passes through the query point and whose tangent is pulled to zero by one
/// equation, by a QR decomposition of the whole system.
inline Section_fit fit_section_by_qr(const std::vector<Eigen::Vector2d>& samples, int degree)
{
  const Eigen::Index n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 1, degree);
  Eigen::VectorXd right_side = Eigen::VectorXd::Zero(n + 1);
  for(Eigen::Index i = 0; i < n; ++i)
  {
    for(int k = 0; k < degree; ++k)
      system(i, k) = std::pow(samples[i].x(), k + 1);
    right_side[i] = samples[i].y();
  }
  system(n, 0) = 1;
  const Eigen::VectorXd c = system.colPivHouseholderQr().solve(right_side);
  const double residual = ((system * c - right_side).head(n)).norm() / std::sqrt(double(n));
  return {-2 * c[1] / std::pow(1 + c[0] * c[0], 1.5), c[0], residual};
}

} // namespace estimation

#endif // CGAL_SPIDER_TEST_ESTIMATION_H
