// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise (paper, 2.5): limbs stop at feature edges, and estimates are those of the smooth patch of the query
// point.

#include "estimation.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Spider/estimate_normal.h>
#include <CGAL/Spider/estimate_normal_curvature.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/trace_limb.h>
#include <CGAL/Spider/trace_limbs.h>

#include <array>
#include <random>
#include <vector>

using namespace estimation;

namespace {

constexpr double radius = 0.5;
constexpr double rounding = 1e-11; // of curvatures, in units of the inverse radius; the worst measured is 4e-13

struct Cube
{
  explicit Cube(int n)
    : mesh(meshes::cube<Mesh>(n)), features(mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first)
  {
    CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 60, features);
  }

  /// returns the axes along which a vertex is at an end of the cube, with the sign of the end.
  Vector sides(Vertex v) const
  {
    return meshes::point(mesh, v).unaryExpr([](double x) { return x == 0 ? -1. : x == 1 ? 1. : 0.; });
  }

  Vertex vertex_at(const Vector& p) const
  {
    for(Vertex v : mesh.vertices())
      if((meshes::point(mesh, v) - p).norm() < 1e-9)
        return v;
    return Mesh::null_vertex();
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> features;
};

} // namespace

TEST(feature_edges, sides_of_a_cube_are_planes_up_to_its_edges)
{
  for(int n : {4, 9})
  {
    Cube cube(n);
    auto curvature = cube.mesh.add_property_map<Vertex, Estimate>("v:curvature").first;
    Spider::estimate_vertex_curvatures(cube.mesh, curvature,
                                       params::geodesic_radius(radius).edge_is_constrained_map(cube.features));
    for(Vertex v : cube.mesh.vertices())
    {
      const Estimate& e = curvature[v];
      SCOPED_TRACE(testing::Message() << meshes::point(cube.mesh, v).transpose());
      EXPECT_NEAR(e.curvedness(), 0, rounding / radius);
      // On an edge or at a corner it is one of the sides that meet there.
      EXPECT_NEAR(meshes::vector(e.normal).cwiseProduct(cube.sides(v)).maxCoeff(), 1, 1e-14);
      const Vector from_centre = (meshes::point(cube.mesh, v) - Vector(.5, .5, .5)).cwiseAbs();
      const bool is_inside = (from_centre.array() < 1e-9).count() == 2; // a radius from all edges of its side
      EXPECT_EQ(e.status == Spider::ok, is_inside);
      const Estimate single = Spider::estimate_curvature(
        v, cube.mesh, params::geodesic_radius(radius).edge_is_constrained_map(cube.features));
      EXPECT_NEAR(single.curvedness(), 0, rounding / radius);
      EXPECT_NEAR(angle(meshes::vector(single.normal), meshes::vector(e.normal)), 0, rounding); // worst 1e-13
      EXPECT_EQ(single.status, e.status);
    }
  }
}

TEST(feature_edges, a_location_on_an_edge_belongs_to_the_side_of_its_face)
{
  const Cube cube(4);
  const auto np = params::geodesic_radius(radius).edge_is_constrained_map(cube.features);
  using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;
  for(auto h : cube.mesh.halfedges())
  {
    if(!cube.features[cube.mesh.edge(h)])
      continue;
    const auto f = cube.mesh.face(h);
    const auto plane = cube.sides(cube.mesh.source(h))
                         .cwiseProduct(cube.sides(cube.mesh.target(h)))
                         .cwiseProduct(cube.sides(cube.mesh.target(cube.mesh.next(h))));
    if(plane.cwiseAbs().sum() != 1)
      continue;                        // a triangle in a corner, all of whose vertices are on edges
    for(double share : {0., 0.25, 1.}) // the source of the face's halfedge comes first
    {
      Location location{f, {0, 0, 0}};
      int i = 0;
      for(auto at = cube.mesh.halfedge(f); at != h; at = cube.mesh.next(at))
        ++i;
      location.second[i] = 1 - share;
      location.second[(i + 1) % 3] = share;
      const auto e = Spider::estimate_curvature(location, cube.mesh, np);
      EXPECT_EQ(e.status, Spider::partial);
      EXPECT_NEAR(e.curvedness(), 0, rounding / radius);
      EXPECT_NEAR(meshes::vector(e.normal).cwiseAbs().dot(plane.cwiseAbs()), 1, 1e-14);
    }
  }
}

TEST(feature_edges, limbs_say_where_they_stopped_and_those_nearly_parallel_go_on)
{
  const Cube cube(10);
  const Vertex v = cube.vertex_at({0.8, 0.5, 1}); // 0.2 from the edge along y
  const Kernel::Vector_3 up(0, 0, 1);
  for(double degrees : {23., 29., 31., 60., 90.})
  {
    SCOPED_TRACE(degrees);
    const double angle = degrees / 180 * meshes::pi, to_edge = 0.2 / std::sin(angle);
    const Kernel::Vector_3 direction(std::sin(angle), std::cos(angle), 0);
    const auto np = params::geodesic_radius(to_edge + 0.1).edge_is_constrained_map(cube.features);
    ASSERT_LT(to_edge * std::cos(angle), 0.5); // else it would meet the next edge first
    const auto limb = Spider::trace_limb(v, up, direction, cube.mesh, np);
    if(degrees > 30)
    {
      EXPECT_EQ(limb.end, Spider::feature_edge);
      EXPECT_NEAR(limb.length, to_edge, 1e-12);
      EXPECT_TRUE(cube.features[limb.edge]);
    }
    else
    {
      EXPECT_EQ(limb.end, Spider::radius_reached);
      EXPECT_NEAR(limb.length, to_edge + 0.1, 1e-12);
    }
    const auto own_angle = params::geodesic_radius(to_edge + 0.1)
                             .minimum_crossing_angle(degrees - 0.01)
                             .edge_is_constrained_map(cube.features);
    EXPECT_EQ(Spider::trace_limb(v, up, direction, cube.mesh, own_angle).end, Spider::feature_edge);
  }
}

TEST(feature_edges, limbs_start_in_every_patch_of_a_point_on_an_edge)
{
  const Cube cube(10);
  const Vertex v = cube.vertex_at({1, 0.5, 1});
  std::vector<Spider::Limb_3<Mesh>> limbs;
  Spider::trace_limbs(v, Kernel::Vector_3(1, 0, 1), cube.mesh, std::back_inserter(limbs),
                      params::geodesic_radius(0.3).number_of_directions(8).edge_is_constrained_map(cube.features));
  ASSERT_EQ(limbs.size(), 16u);
  int on_top = 0, in_front = 0;
  for(const auto& limb : limbs)
  {
    EXPECT_EQ(limb.end, Spider::radius_reached); // no other edge is near
    on_top += limb.polyline.back().z() == 1;
    in_front += limb.polyline.back().x() == 1;
  }
  EXPECT_GE(on_top, 7);
  EXPECT_GE(in_front, 7);
}

TEST(feature_edges, sections_of_a_point_on_an_edge_are_those_of_its_patch)
{
  const Cube cube(10);
  const Vertex v = cube.vertex_at({1, 0.5, 1});
  const auto np = params::geodesic_radius(0.3).edge_is_constrained_map(cube.features);
  const auto normal = Spider::estimate_normal(v, cube.mesh, np);
  const auto across = normal.z() > normal.x() ? Kernel::Vector_3(1, 0, 0) : Kernel::Vector_3(0, 0, 1);
  const auto up = normal.z() > normal.x() ? Kernel::Vector_3(0, 0, 1) : Kernel::Vector_3(1, 0, 0);
  const auto section = Spider::estimate_normal_curvature(v, up, across, cube.mesh, np);
  EXPECT_EQ(section.status, Spider::partial); // one limb only
  EXPECT_NEAR(section.curvature, 0, 1e-12);
  EXPECT_NEAR(section.tangent_slope, 0, 1e-12);
}

// The paper's figure 7, in numbers: where the sides of a noisy cube meet doesn't blur.
TEST(feature_edges, errors_on_a_noisy_cube_are_less_than_a_fifth_of_those_without_features)
{
  constexpr int n = 12;
  Cube cube(n);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-0.25 / n, 0.25 / n);
  std::vector<Vector> sides;
  for(Vertex v : cube.mesh.vertices())
    sides.push_back(cube.sides(v));
  for(Vertex v : cube.mesh.vertices())
  {
    const Vector p = meshes::point(cube.mesh, v) + noise(random) * sides[v].normalized();
    cube.mesh.point(v) = Kernel::Point_3(p.x(), p.y(), p.z());
  }
  const auto errors = [&](const auto& np) {
    auto curvature = cube.mesh.add_property_map<Vertex, Estimate>("v:curvature").first;
    Spider::estimate_vertex_curvatures(cube.mesh, curvature, np);
    std::array<double, 2> sums = {0, 0};
    for(Vertex v : cube.mesh.vertices())
      if(sides[v].cwiseAbs().sum() == 1)
      {
        sums[0] += std::abs(curvature[v].mean_curvature());
        sums[1] += angle(meshes::vector(curvature[v].normal), sides[v]);
      }
    return sums;
  };
  const auto with = errors(params::geodesic_radius(radius).edge_is_constrained_map(cube.features));
  const auto without = errors(params::geodesic_radius(radius));
  EXPECT_LT(with[0], without[0] / 5); // measured: a thirtieth
  EXPECT_LT(with[1], without[1] / 5); // measured: a twentieth
}

TEST(feature_edges, a_crossing_angle_out_of_range_is_refused)
{
  const Cube cube(2);
  for(double degrees : {-1., 91., std::nan("")})
    EXPECT_THROW(Spider::estimate_curvature(Vertex(0), cube.mesh, params::minimum_crossing_angle(degrees)),
                 std::invalid_argument);
}
