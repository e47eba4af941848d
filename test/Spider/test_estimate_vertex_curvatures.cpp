// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"

#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>

#include <CGAL/tags.h>

#include <map>

using namespace estimation;

namespace {

template <typename Tag, typename NamedParameters>
std::map<Vertex, Estimate> curvatures(const Mesh& mesh, const NamedParameters& np)
{
  std::map<Vertex, Estimate> result; // which isn't safe to write to from several threads
  Spider::estimate_vertex_curvatures<Tag>(mesh, boost::make_assoc_property_map(result), np);
  return result;
}

/// expects estimates that were computed alike: to the last bit, unless the compiler fuses products and sums, which it
/// does here in one place and there in another.
void expect_computed_alike(const Estimate& a, const Estimate& b)
{
#ifdef __FP_FAST_FMA
  expect_same(a, b, 1e-12);
#else
  expect_identical(a, b);
#endif
}

} // namespace

TEST(estimate_vertex_curvatures, are_those_of_single_queries)
{
  for(const auto& [name, mesh] : irregular_noisy_meshes())
    for_each_setting(0.5, [&, &name = name, &mesh = mesh](const auto& np) {
      SCOPED_TRACE(name);
      const auto all = curvatures<CGAL::Sequential_tag>(mesh, np);
      ASSERT_EQ(all.size(), mesh.number_of_vertices());
      for(std::size_t i = 0; i < mesh.number_of_vertices(); i += 19)
      {
        const Vertex v(static_cast<Mesh::size_type>(i));
        expect_same(all.at(v), Spider::estimate_curvature(v, mesh, np), 1e-12);
      }
    });
}

TEST(estimate_vertex_curvatures, are_those_of_single_queries_to_the_last_bit)
{
  for(const auto& [name, mesh] : irregular_noisy_meshes())
  {
    SCOPED_TRACE(name);
    std::map<Vertex, double> radii;
    for(Vertex v : mesh.vertices())
      radii[v] = 0.3 + 0.01 * (v.idx() % 30);
    const auto all =
      curvatures<CGAL::Sequential_tag>(mesh, params::geodesic_radius(boost::make_assoc_property_map(radii)));
    for(std::size_t i = 0; i < mesh.number_of_vertices(); i += 19)
    {
      const Vertex v(static_cast<Mesh::size_type>(i));
      expect_computed_alike(all.at(v), Spider::estimate_curvature(v, mesh, params::geodesic_radius(radii.at(v))));
    }
  }
}

TEST(estimate_vertex_curvatures, are_the_same_to_the_last_bit_in_parallel)
{
#ifdef CGAL_LINKED_WITH_TBB
  for(const auto& [name, mesh] : irregular_noisy_meshes())
    for_each_setting(0.3, [&, &name = name, &mesh = mesh](const auto& np) {
      SCOPED_TRACE(name);
      const auto sequential = curvatures<CGAL::Sequential_tag>(mesh, np);
      const auto parallel = curvatures<CGAL::Parallel_tag>(mesh, np);
      ASSERT_EQ(sequential.size(), parallel.size());
      for(const auto& [v, estimate] : sequential)
        expect_identical(estimate, parallel.at(v));
    });
#else
  GTEST_SKIP() << "built without TBB";
#endif
}

TEST(estimate_vertex_curvatures, go_into_a_map_of_another_kernel)
{
  using Narrow = CGAL::Simple_cartesian<float>;
  Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(2), 0.02, 2);
  auto narrow = mesh.add_property_map<Vertex, Spider::Curvature_estimate_3<Narrow>>("v:curvature").first;
  Spider::estimate_vertex_curvatures(mesh, narrow); // with all defaults
  const auto wide = curvatures<CGAL::Sequential_tag>(mesh, CGAL::parameters::default_values());
  for(Vertex v : mesh.vertices())
  {
    EXPECT_TRUE(narrow[v].is_valid());
    EXPECT_EQ(narrow[v].max_curvature, static_cast<float>(wide.at(v).max_curvature));
  }
}

TEST(estimate_vertex_curvatures, of_an_empty_mesh_are_none)
{
  EXPECT_TRUE(curvatures<CGAL::Sequential_tag>(Mesh(), CGAL::parameters::default_values()).empty());
  EXPECT_TRUE(curvatures<CGAL::Sequential_tag>(Mesh(), params::as_published().geodesic_radius(1)).empty());
}
