// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: every result moves and scales with the mesh, and turning the mesh inside out changes signs and nothing
// else. On irregular, noisy meshes, where no symmetry hides a mistake.

#include "estimation.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>

using namespace estimation;
using Rotation = Eigen::Matrix3d;

namespace {

constexpr double radius = 0.5;
constexpr std::size_t stride = 3; // every third vertex tells as much as all

Kernel::Vector_3 rotated(const Rotation& rotation, const Kernel::Vector_3& a)
{
  const Vector b = rotation * vector(a);
  return Kernel::Vector_3(b.x(), b.y(), b.z());
}

} // namespace

TEST(invariance, a_rigid_motion_moves_the_answer)
{
  const Rotation rotation =
    (Eigen::AngleAxisd(0.7, Vector::UnitX()) * Eigen::AngleAxisd(2.3, Vector(1, 2, 3).normalized())).toRotationMatrix();
  const Vector shift(3, -5, 2);
  for(const auto& [name, mesh] : irregular_noisy_meshes())
    for_each_setting(radius, [&, &name = name, &mesh = mesh](const auto& np) {
      SCOPED_TRACE(name);
      const std::vector<Estimate> here = estimates(mesh, np, stride);
      const std::vector<Estimate> there =
        estimates(meshes::moved(mesh, [&](const Vector& p) { return Vector(rotation * p + shift); }), np, stride);
      for(std::size_t i = 0; i < here.size(); ++i)
      {
        SCOPED_TRACE(i);
        Estimate expected = here[i];
        expected.normal = rotated(rotation, expected.normal);
        expected.min_direction = rotated(rotation, expected.min_direction);
        expected.max_direction = rotated(rotation, expected.max_direction);
        expect_same(there[i], expected, 1e-9);
      }
    });
}

TEST(invariance, a_scaling_by_a_power_of_two_scales_the_answer_to_the_last_bit)
{
  for(const auto& [name, mesh] : irregular_noisy_meshes())
  {
    SCOPED_TRACE(name);
    std::vector<std::vector<Estimate>> original;
    for_each_setting(radius, [&, &mesh = mesh](const auto& np) { original.push_back(estimates(mesh, np, stride)); });
    for(double factor : {0x1p-60, 0x1p-7, 0x1p+60})
    {
      const Mesh scaled = meshes::moved(mesh, [&](const Vector& p) { return Vector(factor * p); });
      std::size_t setting = 0;
      for_each_setting(factor * radius, [&](const auto& np) {
        const std::vector<Estimate> answers = estimates(scaled, np, stride);
        for(std::size_t i = 0; i < answers.size(); ++i)
        {
          Estimate expected = original[setting][i];
          expected.min_curvature /= factor;
          expected.max_curvature /= factor;
          expected.residual *= factor;
          expect_identical(answers[i], expected);
        }
        ++setting;
      });
    }
  }
}

TEST(invariance, the_default_radius_scales_too)
{
  const Mesh mesh = irregular_noisy_meshes().front().second;
  const Mesh scaled = meshes::moved(mesh, [](const Vector& p) { return Vector(1024 * p); });
  const auto np = CGAL::parameters::default_values();
  const std::vector<Estimate> original = estimates(mesh, np, stride), answers = estimates(scaled, np, stride);
  for(std::size_t i = 0; i < original.size(); ++i)
  {
    Estimate expected = original[i];
    expected.min_curvature /= 1024;
    expected.max_curvature /= 1024;
    expected.residual *= 1024;
    expect_identical(answers[i], expected);
  }
}

TEST(invariance, turned_inside_out_signs_change_and_nothing_else)
{
  for(const auto& [name, mesh] : irregular_noisy_meshes())
    for_each_setting(radius, [&, &name = name, &mesh = mesh](const auto& np) {
      SCOPED_TRACE(name);
      Mesh reversed = mesh;
      CGAL::Polygon_mesh_processing::reverse_face_orientations(reversed);
      const std::vector<Estimate> outside = estimates(mesh, np, stride), inside = estimates(reversed, np, stride);
      for(std::size_t i = 0; i < outside.size(); ++i)
      {
        SCOPED_TRACE(i);
        Estimate expected = outside[i];
        expected.normal = -outside[i].normal;
        expected.min_curvature = -outside[i].max_curvature;
        expected.max_curvature = -outside[i].min_curvature;
        expected.min_direction = outside[i].max_direction;
        expected.max_direction = outside[i].min_direction;
        expect_same(inside[i], expected, 1e-9);
      }
    });
}

TEST(invariance, where_in_the_mesh_a_vertex_is_does_not_matter)
{
  // A second component, far away and listed first, shifts every index.
  const Mesh mesh = irregular_noisy_meshes().front().second;
  Mesh both = meshes::moved(meshes::icosphere<Mesh>(1), [](const Vector& p) { return Vector(p + Vector(50, 0, 0)); });
  const std::size_t first = both.number_of_vertices();
  both += mesh;
  for_each_setting(radius, [&](const auto& np) {
    const std::vector<Estimate> alone = estimates(mesh, np), together = estimates(both, np);
    for(std::size_t i = 0; i < alone.size(); ++i)
      expect_same(together[first + i], alone[i], 1e-12);
  });
}
