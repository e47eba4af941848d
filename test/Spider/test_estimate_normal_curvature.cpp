// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"

#include <CGAL/Spider/estimate_normal_curvature.h>
#include <CGAL/Spider/resample.h>
#include <CGAL/Spider/trace_limb.h>

using namespace estimation;
using Triple = Kernel::Vector_3;

namespace {

/// returns the samples of both limbs in units of the radius, from the public functions alone.
std::vector<Eigen::Vector2d> samples_of(Vertex v, const Vector& normal, const Vector& direction, const Mesh& mesh,
                                        double radius)
{
  std::vector<Eigen::Vector2d> samples;
  for(int sign : {1, -1})
  {
    const Vector d = sign * direction;
    const auto limb = Spider::trace_limb(v, Triple(normal.x(), normal.y(), normal.z()), Triple(d.x(), d.y(), d.z()),
                                         mesh, params::geodesic_radius(radius));
    const auto points = Spider::resample(limb, 0.1 * radius);
    for(std::size_t i = 1; i < points.size(); ++i)
    {
      const Vector a = (vector(points[i]) - meshes::point(mesh, v)) / radius;
      samples.emplace_back(a.dot(direction), a.dot(normal));
    }
  }
  return samples;
}

} // namespace

TEST(estimate_normal_curvature, is_the_fit_to_the_resampled_limbs)
{
  for(const auto& [name, mesh] : irregular_noisy_meshes())
    for(int degree : {2, 3, 4})
      for(std::size_t i = 0; i < mesh.number_of_vertices(); i += 29)
      {
        SCOPED_TRACE(name);
        const Vertex v(static_cast<Mesh::size_type>(i));
        const double radius = 0.5;
        const auto np = params::as_published().geodesic_radius(radius).polynomial_degree(degree);
        const Vector normal = vector(Spider::estimate_normal(v, mesh, np));
        const Vector direction = normal.cross(Vector(0.3, 0.5, 0.8)).normalized();
        const auto samples = samples_of(v, normal, direction, mesh, radius);
        const auto got = Spider::estimate_normal_curvature(
          v, Triple(normal.x(), normal.y(), normal.z()), Triple(direction.x(), direction.y(), direction.z()), mesh, np);
        if(!(got.status == Spider::ok))
          continue; // limbs that end at a border may be too short to compare digits
        const Section_fit expected = fit_section_by_qr(samples, degree);
        EXPECT_NEAR(got.curvature * radius, expected.curvature, 1e-9 * (1 + std::abs(expected.curvature)));
        EXPECT_NEAR(got.tangent_slope, expected.slope, 1e-9);
        EXPECT_NEAR(got.residual / radius, expected.residual, 1e-9);
      }
}

TEST(estimate_normal_curvature, has_the_sign_and_size_of_a_cylinders)
{
  const double R = 2;
  const Mesh cylinder = meshes::cylinder<Mesh>(R, 4, 80, 24);
  const Vertex v(12); // at (R, 0, 2)
  const Triple outwards(1, 0, 0), around(0, 1, 0), along(0, 0, 1);
  const auto np = params::as_published().geodesic_radius(0.8);
  const auto curvature = [&](const Triple& n, const Triple& d) {
    const auto result = Spider::estimate_normal_curvature(v, n, d, cylinder, np);
    EXPECT_EQ(result.status, Spider::ok);
    EXPECT_NEAR(result.tangent_slope, 0, 1e-3);
    return result.curvature;
  };
  // A chord of the section lies below the arc and a quadratic above the circle: together 4.1 % at this radius.
  EXPECT_NEAR(curvature(outwards, around), 1 / R, 0.06 / R);
  EXPECT_NEAR(curvature(-outwards, around), -1 / R, 0.06 / R);
  EXPECT_NEAR(curvature(outwards, along), 0, 1e-12);
  EXPECT_NEAR(curvature(outwards, around + along), 0.5 / R, 0.06 / R); // Euler's theorem
  EXPECT_NEAR(curvature(10 * outwards, 3 * around), curvature(outwards, around), 1e-12);
  EXPECT_NEAR(curvature(outwards, around + 5 * outwards), curvature(outwards, around), 1e-12);
}

TEST(estimate_normal_curvature, tells_the_slope_of_the_tangent)
{
  const Mesh plane = meshes::plane<Mesh>(10, 0.1);
  const double tilt = 0.2; // of the normal against the direction, along which the section falls
  const Triple normal(-std::sin(tilt), 0, std::cos(tilt)), direction(1, 0, 0);
  const auto result = Spider::estimate_normal_curvature(Vertex(220), normal, direction, plane,
                                                        params::as_published().geodesic_radius(0.5));
  EXPECT_EQ(result.status, Spider::ok);
  // The section is a straight line, whose samples at i/10 of the radius on either side work against the tangent's
  // own equation, in which the sum of the squares of the abscissae is 7.7 cos² of the tilt.
  const double s = 7.7 * std::cos(tilt) * std::cos(tilt), slope = std::tan(tilt) * s / (s + 1);
  EXPECT_NEAR(result.tangent_slope, -slope, 1e-12);
  EXPECT_NEAR(result.curvature, 0, 1e-12);
  EXPECT_GT(result.residual, 0);
}

TEST(estimate_normal_curvature, is_partial_at_a_border)
{
  const Mesh cylinder = meshes::cylinder<Mesh>(1, 2, 80, 24);
  const Vertex at_border(0);
  const auto np = params::as_published().geodesic_radius(0.5);
  const auto along = Spider::estimate_normal_curvature(at_border, Triple(1, 0, 0), Triple(0, 0, 1), cylinder, np);
  EXPECT_EQ(along.status, Spider::partial);
  EXPECT_NEAR(along.curvature, 0, 1e-12);
  const auto oblique = Spider::estimate_normal_curvature(at_border, Triple(1, 0, 0), Triple(0, 1, 1), cylinder, np);
  EXPECT_EQ(oblique.status, Spider::partial);
  EXPECT_NEAR(oblique.curvature, 0.5, 0.1); // from one limb alone; measured 0.46
}

TEST(estimate_normal_curvature, is_nan_where_nothing_determines_it)
{
  Mesh mesh = meshes::icosphere<Mesh>(1);
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(5, 5, 5));
  const auto np = params::as_published().geodesic_radius(0.5);
  const auto alone = Spider::estimate_normal_curvature(isolated, Triple(1, 0, 0), Triple(0, 1, 0), mesh, np);
  EXPECT_EQ(alone.status, Spider::isolated);
  EXPECT_TRUE(std::isnan(alone.curvature) && std::isnan(alone.tangent_slope) && std::isnan(alone.residual));

  // Neither of the two limbs along the diagonal is in the corner of this triangle.
  const Mesh triangle = meshes::from_soup<Mesh>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto outside = Spider::estimate_normal_curvature(Vertex(0), Triple(0, 0, 1), Triple(1, -1, 0), triangle, np);
  EXPECT_EQ(outside.status, Spider::insufficient);
  EXPECT_TRUE(std::isnan(outside.curvature));
}
