// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: any model of the concepts that the reference names will do, since archetypes of them do, and they give
// the answers that a mesh of CGAL gives.

#include "archetypes.h"
#include "estimation.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Spider.h>

using namespace estimation;

namespace {

using Graph = archetypes::Graph;
using Estimate_of_archetype = Spider::Curvature_estimate_3<archetypes::Kernel>;
using Location = std::pair<Graph::Face, std::array<double, 3>>;

const Mesh& model()
{
  static const Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(2), 0.02, 1);
  return mesh;
}

void expect_answer(const Estimate_of_archetype& got, const Estimate& expected)
{
  expect_same(Estimate(got), expected, 1e-9);
}

} // namespace

TEST(concepts, archetypes_can_be_asked_for_curvature)
{
  const Graph graph(model());
  const archetypes::Readable_map<Graph::Vertex, double> radius([](const Graph::Vertex&) { return 0.7; });
  const archetypes::Readable_map<Graph::Face, double> cost([](const Graph::Face&) { return 1.; });
  const archetypes::Readable_map<Graph::Edge, bool> no_features([](const Graph::Edge&) { return false; });
  const auto np = params::geodesic_radius(radius)
                    .growth_cost_map(cost)
                    .edge_is_constrained_map(no_features)
                    .geom_traits(archetypes::Kernel());

  std::map<Graph::Vertex, Estimate_of_archetype> curvatures;
  Spider::estimate_vertex_curvatures(graph, archetypes::Writable_map<Graph::Vertex, Estimate_of_archetype>(curvatures),
                                     np);
  const std::vector<Estimate> expected = estimates(model(), params::geodesic_radius(0.7));
  std::size_t number = 0;
  for(const Graph::Vertex& v : vertices(graph))
    expect_answer(curvatures.at(v), expected[number++]);
  expect_answer(Spider::estimate_curvature(*vertices(graph).begin(), graph, np), expected.front());

  const std::array<double, 3> weights = {0.2, 0.3, 0.5};
  const std::vector<Location> queries = {{*faces(graph).begin(), weights}};
  std::vector<Estimate_of_archetype> in_faces;
  Spider::estimate_curvatures(queries, graph, std::back_inserter(in_faces), np);
  expect_answer(in_faces.front(), Spider::estimate_curvature(std::make_pair(Mesh::Face_index(0), weights), model(),
                                                             params::geodesic_radius(0.7)));
}

TEST(concepts, archetypes_can_be_traced)
{
  const Graph graph(model());
  const Graph::Vertex v = *vertices(graph).begin();
  const archetypes::Kernel::Vector_3 normal = Spider::estimate_normal(v, graph), direction(1, 2, 3);
  const auto np = params::geodesic_radius(0.7);
  const auto limb = Spider::trace_limb(v, normal, direction, graph, np);
  EXPECT_EQ(limb.end, Spider::radius_reached);
  EXPECT_GE(Spider::resample(limb, 0.1).size(), 8u);
  std::vector<archetypes::Kernel::Point_3> ring;
  Spider::geodesic_ring(v, normal, graph, std::back_inserter(ring), np);
  EXPECT_EQ(ring.size(), 128u);
  EXPECT_EQ(Spider::trace_sphere_section(v, graph, np).size(), 1u);
  EXPECT_EQ(Spider::estimate_normal_curvature(v, normal, direction, graph, np).status, Spider::ok);
  std::map<Graph::Vertex, archetypes::Kernel::Vector_3> normals;
  Spider::estimate_vertex_normals(graph,
                                  archetypes::Writable_map<Graph::Vertex, archetypes::Kernel::Vector_3>(normals));
  EXPECT_LE((vector(normals.at(v)) - vector(normal)).norm(), 1e-12);
}

TEST(concepts, archetypes_can_be_labelled_drawn_on_and_smoothed)
{
  Graph graph(model());
  EXPECT_NEAR(Spider::suggest_geodesic_radius(graph), Spider::suggest_geodesic_radius(model()), 1e-9);
  std::map<Graph::Vertex, double> radii;
  Spider::suggest_geodesic_radii(graph, archetypes::Writable_map<Graph::Vertex, double>(radii));
  EXPECT_EQ(radii.size(), vertices(graph).size());
  radii.clear();
  Spider::suggest_adaptive_radii(graph, archetypes::Writable_map<Graph::Vertex, double>(radii));
  EXPECT_EQ(radii.size(), vertices(graph).size());
  std::map<Graph::Vertex, archetypes::Kernel::Vector_3> elongations;
  const archetypes::Writable_map<Graph::Vertex, archetypes::Kernel::Vector_3> elongation_map(elongations);
  Spider::suggest_adaptive_radii(graph, archetypes::Writable_map<Graph::Vertex, double>(radii),
                                 params::limb_elongation_map(elongation_map));
  EXPECT_EQ(elongations.size(), vertices(graph).size());

  const archetypes::Readable_map<Graph::Vertex, Estimate_of_archetype> curvature(
    [&](const Graph::Vertex& v) { return Spider::estimate_curvature(v, graph); });
  std::map<Graph::Vertex, Spider::Vertex_label> labels;
  Spider::classify_vertices(graph, curvature, archetypes::Writable_map<Graph::Vertex, Spider::Vertex_label>(labels));
  EXPECT_EQ(labels.size(), vertices(graph).size());

  const archetypes::Readable_map<Graph::Vertex, double> height(
    [&](const Graph::Vertex& v) { return get(get(CGAL::vertex_point, graph), v).z(); });
  std::vector<Spider::Isoline_3<Graph>> lines;
  Spider::extract_isolines(graph, height, 0.1, std::back_inserter(lines));
  EXPECT_EQ(lines.size(), 1u);
  std::vector<Spider::Ridge_3<Graph>> ridges;
  Spider::extract_ridges(graph, curvature, std::back_inserter(ridges), params::minimum_sharpness(1e9));
  EXPECT_TRUE(ridges.empty());
  EXPECT_GT(Spider::smooth_by_geodesic_rings(graph, params::smoothing_factor(0.5)).greatest_displacement, 0);
}
