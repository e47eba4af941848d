// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Spider/estimate_curvatures.h>

#include <CGAL/tags.h>

#include <iterator>
#include <list>

using namespace estimation;
using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;

TEST(estimate_curvatures, answers_each_query_in_their_order)
{
  for(const auto& [name, mesh] : irregular_noisy_meshes())
    for_each_setting(0.4, [&, &name = name, &mesh = mesh](const auto& np) {
      SCOPED_TRACE(name);
      const std::list<Vertex> queries = {Vertex(30), Vertex(7), Vertex(30), Vertex(211)};
      std::vector<Estimate> answers;
      Spider::estimate_curvatures(queries, mesh, std::back_inserter(answers), np);
      ASSERT_EQ(answers.size(), queries.size());
      auto answer = answers.begin();
      for(Vertex v : queries)
        expect_same(*answer++, Spider::estimate_curvature(v, mesh, np), 1e-12);
    });
}

TEST(estimate_curvatures, takes_points_of_faces)
{
  const Mesh mesh = irregular_noisy_meshes().front().second;
  std::vector<Location> queries;
  for(Mesh::size_type f = 0; f < 20; ++f)
    queries.emplace_back(Mesh::Face_index(7 * f), std::array<double, 3>{0.1 + 0.04 * f, 0.1, 0.8 - 0.04 * f});
  for_each_setting(0.4, [&](const auto& np) {
    std::vector<Estimate> answers(queries.size());
    const auto end = Spider::estimate_curvatures(queries, mesh, answers.begin(), np);
    EXPECT_EQ(end, answers.end());
    for(std::size_t i = 0; i < queries.size(); ++i)
      expect_same(answers[i], Spider::estimate_curvature(queries[i], mesh, np), 1e-12);
  });
}

TEST(estimate_curvatures, is_the_same_to_the_last_bit_in_parallel)
{
#ifdef CGAL_LINKED_WITH_TBB
  const Mesh mesh = irregular_noisy_meshes().front().second;
  // More queries than are handed out at a time.
  std::vector<Vertex> queries;
  for(std::size_t i = 0; i < 9000; ++i)
    queries.emplace_back(static_cast<Mesh::size_type>(i * 7 % mesh.number_of_vertices()));
  const auto np = params::geodesic_radius(0.2).number_of_directions(8);
  std::vector<Estimate> sequential, parallel;
  Spider::estimate_curvatures<CGAL::Sequential_tag>(queries, mesh, std::back_inserter(sequential), np);
  Spider::estimate_curvatures<CGAL::Parallel_tag>(queries, mesh, std::back_inserter(parallel), np);
  ASSERT_EQ(sequential.size(), queries.size());
  ASSERT_EQ(parallel.size(), queries.size());
  for(std::size_t i = 0; i < queries.size(); ++i)
    expect_identical(sequential[i], parallel[i]);
#else
  GTEST_SKIP() << "built without TBB";
#endif
}

TEST(estimate_curvatures, of_nothing_are_none)
{
  const Mesh mesh = meshes::icosphere<Mesh>(1);
  std::vector<Estimate> answers;
  Spider::estimate_curvatures(std::vector<Vertex>(), mesh, std::back_inserter(answers));
  EXPECT_TRUE(answers.empty());
}
