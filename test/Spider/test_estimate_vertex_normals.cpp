// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"

#include <CGAL/Spider/estimate_normal.h>
#include <CGAL/Spider/estimate_vertex_normals.h>

#include <CGAL/tags.h>

#include <map>

using namespace estimation;

namespace {

template <typename Tag, typename NamedParameters>
std::map<Vertex, Kernel::Vector_3> normals(const Mesh& mesh, const NamedParameters& np)
{
  std::map<Vertex, Kernel::Vector_3> result; // which isn't safe to write to from several threads
  Spider::estimate_vertex_normals<Tag>(mesh, boost::make_assoc_property_map(result), np);
  return result;
}

} // namespace

TEST(estimate_vertex_normals, are_those_of_single_queries)
{
  for(const auto& [name, mesh] : irregular_noisy_meshes())
    for(Spider::First_normal kind : {Spider::incident_faces, Spider::neighbourhood, Spider::sphere_section})
    {
      SCOPED_TRACE(name);
      const auto np = params::geodesic_radius(0.5).first_normal(kind);
      const auto all = normals<CGAL::Sequential_tag>(mesh, np);
      ASSERT_EQ(all.size(), mesh.number_of_vertices());
      for(std::size_t i = 0; i < mesh.number_of_vertices(); i += 17)
      {
        const Vertex v(static_cast<Mesh::size_type>(i));
        EXPECT_LE(angle(vector(all.at(v)), vector(Spider::estimate_normal(v, mesh, np))), 1e-12);
      }
    }
}

TEST(estimate_vertex_normals, are_the_same_to_the_last_bit_in_parallel)
{
#ifdef CGAL_LINKED_WITH_TBB
  for(const auto& [name, mesh] : irregular_noisy_meshes())
    for_each_setting(0.3, [&, &mesh = mesh](const auto& np) {
      EXPECT_EQ(normals<CGAL::Sequential_tag>(mesh, np), normals<CGAL::Parallel_tag>(mesh, np));
    });
#else
  GTEST_SKIP() << "built without TBB";
#endif
}

TEST(estimate_vertex_normals, go_into_a_map_of_another_kernel)
{
  using Narrow = CGAL::Simple_cartesian<float>;
  Mesh mesh = meshes::icosphere<Mesh>(2);
  auto narrow = mesh.add_property_map<Vertex, Narrow::Vector_3>("v:normal").first;
  Spider::estimate_vertex_normals(mesh, narrow); // with the default radius
  for(Vertex v : mesh.vertices())
    EXPECT_LE((vector(narrow[v]) - vector(Spider::estimate_normal(v, mesh))).norm(), 1e-6);
}

TEST(estimate_vertex_normals, of_isolated_vertices_are_nan)
{
  Mesh mesh = meshes::icosphere<Mesh>(1);
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(5, 5, 5));
  const auto all = normals<CGAL::Sequential_tag>(mesh, params::geodesic_radius(0.5));
  for(const auto& [v, n] : all)
    EXPECT_EQ(vector(n).array().isNaN().all(), v == isolated);
}
