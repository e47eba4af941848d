// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Spider/estimate_normal.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <thread>

using namespace estimation;

TEST(Curvature_estimator, agrees_with_single_queries_at_vertices)
{
  for(const auto& [name, mesh] : irregular_noisy_meshes())
    for_each_setting(0.5, [&, &name = name, &mesh = mesh](const auto& np) {
      SCOPED_TRACE(name);
      const Spider::Curvature_estimator<Mesh, std::decay_t<decltype(np)>> estimator(mesh, np);
      for(std::size_t i = 0; i < mesh.number_of_vertices(); i += 23)
      {
        const Vertex v(static_cast<Mesh::size_type>(i));
        expect_same(estimator(v), Spider::estimate_curvature(v, mesh, np), 1e-12);
        EXPECT_LE(angle(vector(estimator.normal(v)), vector(Spider::estimate_normal(v, mesh, np))), 1e-12);
      }
    });
}

TEST(Curvature_estimator, agrees_with_single_queries_in_faces_and_on_edges)
{
  using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;
  for(const auto& [name, mesh] : irregular_noisy_meshes())
    for_each_setting(0.5, [&, &name = name, &mesh = mesh](const auto& np) {
      SCOPED_TRACE(name);
      const Spider::Curvature_estimator<Mesh, std::decay_t<decltype(np)>> estimator(mesh, np);
      for(std::size_t i = 0; i < mesh.number_of_faces(); i += 97)
        for(const auto& coordinates : {std::array<double, 3>{0.2, 0.3, 0.5}, std::array<double, 3>{0, 0.25, 0.75}})
        {
          const Location location(Mesh::Face_index(static_cast<Mesh::size_type>(i)), coordinates);
          expect_same(estimator(location), Spider::estimate_curvature(location, mesh, np), 1e-12);
          EXPECT_LE(angle(vector(estimator.normal(location)), vector(Spider::estimate_normal(location, mesh, np))),
                    1e-12);
        }
    });
}

TEST(Curvature_estimator, keeps_the_mesh_as_it_was)
{
  Mesh mesh = meshes::icosphere<Mesh>(2);
  const auto np = params::geodesic_radius(0.7);
  const Spider::Curvature_estimator<Mesh, std::decay_t<decltype(np)>> estimator(mesh, np);
  const Estimate before = estimator(Vertex(0));
  for(Vertex v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN;
  expect_identical(estimator(Vertex(0)), before);
}

TEST(Curvature_estimator, copes_with_vertices_and_faces_that_were_removed)
{
  Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(3), 0.02, 5);
  Mesh with_garbage = mesh;
  const Vertex removed(7);
  CGAL::Euler::remove_center_vertex(with_garbage.halfedge(removed), with_garbage);
  CGAL::Polygon_mesh_processing::triangulate_faces(with_garbage);
  ASSERT_TRUE(with_garbage.has_garbage());
  const Soup soup = soup_of(with_garbage); // numbered without gaps, in the same order
  const Mesh compact = meshes::from_soup<Mesh>(soup.points, soup.triangles);
  for_each_setting(0.5, [&](const auto& np) {
    const std::vector<Estimate> expected = estimates(compact, np), got = estimates(with_garbage, np);
    ASSERT_EQ(expected.size(), got.size());
    for(std::size_t i = 0; i < got.size(); ++i)
      expect_same(expected[i], got[i], 1e-12);
    EXPECT_THROW(Spider::Curvature_estimator(with_garbage, np)(removed), std::invalid_argument);
  });
}

TEST(Curvature_estimator, answers_several_threads_at_once)
{
  const Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(3), 0.02, 5);
  for_each_setting(0.4, [&](const auto& np) {
    const Spider::Curvature_estimator<Mesh, std::decay_t<decltype(np)>> estimator(mesh, np);
    std::vector<std::vector<Estimate>> answers(4);
    std::vector<std::thread> threads;
    for(auto& of_thread : answers)
      threads.emplace_back([&] {
        for(Vertex v : mesh.vertices())
          of_thread.push_back(estimator(v));
      });
    for(std::thread& thread : threads)
      thread.join();
    for(std::size_t t = 1; t < answers.size(); ++t)
      for(std::size_t i = 0; i < answers[t].size(); ++i)
        expect_identical(answers[t][i], answers[0][i]);
  });
}

TEST(Curvature_estimator, is_the_same_however_many_threads_read)
{
  const Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(5), 0.01, 5); // large enough to be read in parts
  const auto np = params::geodesic_radius(0.1);
  const Spider::Curvature_estimator by_one(mesh, np, CGAL::Sequential_tag());
  const Spider::Curvature_estimator by_several(mesh, np, CGAL::Parallel_if_available_tag());
  const std::vector<Vertex> order = by_one.vertices_in_spatial_order();
  EXPECT_EQ(by_several.vertices_in_spatial_order<CGAL::Parallel_if_available_tag>(), order);
  for(std::size_t i = 0; i < order.size(); i += 7)
  {
    EXPECT_EQ(by_one.normal(order[i]), by_several.normal(order[i]));
    expect_identical(by_one(order[i]), by_several(order[i]));
  }
}

TEST(Curvature_estimator, refuses_what_is_not_of_the_mesh)
{
  const Mesh mesh = meshes::icosphere<Mesh>(1);
  const Spider::Curvature_estimator<Mesh> estimator(mesh);
  using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;
  EXPECT_THROW(estimator(Vertex(1000)), std::invalid_argument);
  EXPECT_THROW(estimator(Mesh::null_vertex()), std::invalid_argument);
  EXPECT_THROW(estimator(Location(Mesh::Face_index(1000), {1, 0, 0})), std::invalid_argument);
  EXPECT_THROW(estimator(Location(Mesh::null_face(), {1, 0, 0})), std::invalid_argument);
}
