// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../mesh_types.h"
#include "test_meshes.h"

#include <gtest/gtest.h>

#include <set>

using namespace CGAL::Spider::benchmark;

namespace {

constexpr double sphere_radius = 2;

const Mesh& sphere()
{
  static const Mesh mesh = test::make_sphere(3, sphere_radius);
  return mesh;
}

TEST(MeshTypes, AreTold)
{
  std::set<std::string> names;
  for(const Mesh_type& type : all_mesh_types())
    names.insert(type.name);
  EXPECT_EQ(names.size(), all_mesh_types().size());
}

// On a coarse sphere a quadratic's mean curvature is 1.5 % off, by the same for all types but for a float's digits.
TEST(MeshTypes, GiveTheSameCurvatures)
{
  const Spider_settings settings{0.5, 16, 1};
  const double expected = all_mesh_types().front().run_on_copy_of(sphere())(settings);
  EXPECT_NEAR(expected * sphere_radius / double(sphere().number_of_vertices()), 1, 0.03);
  for(const Mesh_type& type : all_mesh_types())
    EXPECT_NEAR(type.run_on_copy_of(sphere())(settings), expected, 1e-5 * expected) << type.name;
}

TEST(MeshTypes, HeedDirections)
{
  const Spider_run run = all_mesh_types().front().run_on_copy_of(sphere());
  EXPECT_NE(run({0.5, 7, 1}), run({0.5, 0, 1}));
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(MeshTypes, GiveTheSameWithMoreThreads)
{
  for(const Mesh_type& type : all_mesh_types())
  {
    const Spider_run run = type.run_on_copy_of(sphere());
    EXPECT_EQ(run({0.5, 0, 1}), run({0.5, 0, 2})) << type.name;
  }
}
#endif

} // namespace
