// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spider/extract_ridges.h>

#include "estimation.h"
#include "tracing.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/property_map.hpp>

#include <map>
#include <random>

using namespace estimation;

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using tracing::expect_refused;
using Ridge = Spider::Ridge_3<Mesh>;
using Estimates = std::map<Vertex, Estimate>;

Mesh ellipsoid(int subdivisions, double x, double y, double z)
{
  return meshes::moved(meshes::icosphere<Mesh>(subdivisions),
                       [&](const Vector& p) { return Vector(x * p.x(), y * p.y(), z * p.z()); });
}

template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Ridge> ridges(const Mesh& mesh, const Estimates& estimates,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  std::vector<Ridge> result;
  Spider::extract_ridges(mesh, boost::const_associative_property_map<Estimates>(estimates), std::back_inserter(result),
                         np);
  return result;
}

Estimates estimated(const Mesh& mesh, double radius)
{
  Estimates result;
  Spider::estimate_vertex_curvatures(mesh, boost::make_assoc_property_map(result), params::geodesic_radius(radius));
  return result;
}

double length(const Ridge& line)
{
  double sum = 0;
  for(std::size_t i = 1; i < line.points.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(line.points[i - 1], line.points[i]));
  return sum;
}

double perimeter_of_ellipse(double a, double b)
{
  constexpr int steps = 10000;
  double sum = 0;
  for(int i = 0; i < steps; ++i)
  {
    const double t = 2 * meshes::pi * i / steps;
    sum += std::hypot(a * std::sin(t), b * std::cos(t)) * 2 * meshes::pi / steps;
  }
  return sum;
}

double greatest_z(const Ridge& line)
{
  double greatest = 0;
  for(const auto& p : line.points)
    greatest = std::max(greatest, std::abs(p.z()));
  return greatest;
}

/// Curvature across the x-axis of a plane that is greatest along it, with directions of signs at random.
template <typename Curvature>
Estimates across_x_axis(const Mesh& mesh, Curvature&& curvature)
{
  std::mt19937 random(3);
  Estimates result;
  for(Vertex v : mesh.vertices())
  {
    Estimate& e = result[v];
    e.min_curvature = 0;
    e.max_curvature = curvature(meshes::point(mesh, v));
    e.min_direction = Kernel::Vector_3(1, 0, 0);
    e.max_direction = Kernel::Vector_3(0, random() % 2 == 0 ? 1 : -1, 0);
  }
  return result;
}

} // namespace

TEST(extract_ridges, finds_the_one_of_an_ellipsoid)
{
  constexpr double radius = 0.3;
  double error = 0.1;
  for(int subdivisions : {3, 4, 5})
  {
    const Mesh mesh = ellipsoid(subdivisions, 2, 1.4, 1);
    const auto lines = ridges(mesh, estimated(mesh, radius), params::geodesic_radius(radius));
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].is_closed);
    EXPECT_EQ(lines[0].points.front(), lines[0].points.back());
    EXPECT_EQ(lines[0].kind, Spider::ridge);
    EXPECT_LT(greatest_z(lines[0]), 1e-4); // measured: 1e-6
    const double new_error = std::abs(length(lines[0]) - perimeter_of_ellipse(2, 1.4));
    EXPECT_LT(new_error, error / 3.); // of second order
    error = new_error;
    // The curvature across is from 1.4 to 2.
    EXPECT_GT(lines[0].strength, 1.4 * length(lines[0]));
    EXPECT_LT(lines[0].strength, 2 * length(lines[0]));
  }
}

TEST(extract_ridges, finds_valleys_on_a_mesh_turned_inside_out)
{
  Mesh mesh = ellipsoid(4, 2, 1.4, 1);
  const auto out = ridges(mesh, estimated(mesh, 0.3), params::geodesic_radius(0.3));
  PMP::reverse_face_orientations(mesh);
  const auto in = ridges(mesh, estimated(mesh, 0.3), params::geodesic_radius(0.3));
  ASSERT_EQ(out.size(), 1u);
  ASSERT_EQ(in.size(), 1u);
  EXPECT_EQ(in[0].kind, Spider::valley);
  EXPECT_NEAR(length(in[0]), length(out[0]), 1e-6);
  EXPECT_NEAR(in[0].strength, out[0].strength, 1e-6);
  EXPECT_NEAR(in[0].sharpness, out[0].sharpness, 1e-6);
}

TEST(extract_ridges, stays_on_the_ridge_in_noise)
{
  const Mesh clean = ellipsoid(5, 2, 1.4, 1);
  const double edge = meshes::mean_edge_length(clean), radius = 6 * edge;
  for(unsigned seed : {1u, 2u, 3u})
  {
    Mesh mesh = clean;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> offset(-0.25 * edge / 2, 0.25 * edge / 2);
    for(Vertex v : mesh.vertices())
      mesh.point(v) = clean.point(v) + offset(random) * PMP::compute_vertex_normal(v, clean);
    double total = 0;
    for(const Ridge& line : ridges(mesh, estimated(mesh, radius), params::geodesic_radius(radius)))
    {
      total += length(line);
      EXPECT_LT(greatest_z(line), 0.5 * radius); // measured: 0.12 to 0.35
    }
    EXPECT_NEAR(total / perimeter_of_ellipse(2, 1.4), 1, 0.05); // measured: 1.007 to 1.009
  }
}

// The greater curvature of a torus is the same everywhere, and so is that of a sphere.
TEST(extract_ridges, finds_none_where_curvature_is_not_greater_than_beside)
{
  const Mesh torus = meshes::torus<Mesh>(1, 0.4, 80, 32);
  EXPECT_TRUE(ridges(torus, estimated(torus, 0.2), params::geodesic_radius(0.2)).empty()); // measured: sharpness 0.21
  const Mesh sphere = meshes::icosphere<Mesh>(4);
  EXPECT_TRUE(ridges(sphere, estimated(sphere, 0.3), params::geodesic_radius(0.3)).empty());
}

TEST(extract_ridges, follows_an_exact_ridge_through_vertices_and_beside_them)
{
  constexpr int half = 10;
  const Mesh mesh = meshes::plane<Mesh>(half);
  for(double y : {0., 0.25, 0.5})
  {
    const auto curvature = [&](const Vector& p) { return 1 - 0.001 * (p.y() - y) * (p.y() - y); };
    const auto lines = ridges(mesh, across_x_axis(mesh, curvature),
                              params::geodesic_radius(1.).minimum_sharpness(0.)); // so no averaging
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_FALSE(lines[0].is_closed);
    EXPECT_NEAR(length(lines[0]), 2 * half, 0.5);
    EXPECT_NEAR(lines[0].strength, length(lines[0]), 1e-2);
    EXPECT_NEAR(lines[0].sharpness, 0.002, 2e-4);
    for(std::size_t i = 0; i < lines[0].points.size(); ++i)
    {
      if(std::abs(lines[0].points[i].x()) <= half - 2) // on the border, derivatives are those of one side
      {
        EXPECT_NEAR(lines[0].points[i].y(), y, 1e-12);
      }
      const auto p = CGAL::Polygon_mesh_processing::construct_point(lines[0].locations[i], mesh);
      EXPECT_LE(CGAL::squared_distance(p, lines[0].points[i]), 1e-24);
    }
  }
}

TEST(extract_ridges, leaves_out_where_curvature_is_least_or_not_the_greater_one)
{
  const Mesh mesh = meshes::plane<Mesh>(10);
  const auto count = [&](double at_axis, double beside, double along) {
    auto estimates =
      across_x_axis(mesh, [&](const Vector& p) { return at_axis + (beside - at_axis) * p.y() * p.y() / 100; });
    for(auto& one : estimates)
      one.second.min_curvature = along;
    return ridges(mesh, estimates, params::minimum_sharpness(0.)).size();
  };
  EXPECT_EQ(count(2, 1, 0), 1u);
  EXPECT_EQ(count(1, 2, 0), 0u);
  EXPECT_EQ(count(2, 1, -1.9), 1u);
  EXPECT_EQ(count(2, 1, -2.1), 0u);
}

TEST(extract_ridges, ends_where_there_is_no_estimate)
{
  const Mesh mesh = meshes::plane<Mesh>(10);
  auto estimates = across_x_axis(mesh, [](const Vector& p) { return 1 - 0.001 * p.y() * p.y(); });
  for(Vertex v : mesh.vertices())
    if(mesh.point(v) == Kernel::Point_3(2, 0, 0))
      estimates[v] = Estimate();
  const auto lines = ridges(mesh, estimates, params::minimum_sharpness(0.).minimum_strength(0.));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NEAR(length(lines[0]) + length(lines[1]), 20 - 2, 0.2); // but for the faces around the vertex
  for(const Ridge& line : lines)
    for(const auto& p : line.points)
      EXPECT_GE(std::abs(p.x() - 2), 1 - 1e-9);
}

TEST(extract_ridges, leaves_out_what_is_weak_or_blunt)
{
  const Mesh mesh = ellipsoid(4, 2, 1.4, 1);
  const auto estimates = estimated(mesh, 0.3);
  const auto np = params::geodesic_radius(0.3);
  const auto lines = ridges(mesh, estimates, np);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(ridges(mesh, estimates, np.minimum_strength(0.999 * lines[0].strength)).size(), 1u);
  EXPECT_EQ(ridges(mesh, estimates, np.minimum_strength(1.001 * lines[0].strength)).size(), 0u);
  EXPECT_EQ(ridges(mesh, estimates, np.minimum_sharpness(0.999 * lines[0].sharpness)).size(), 1u);
  EXPECT_EQ(ridges(mesh, estimates, np.minimum_sharpness(1.001 * lines[0].sharpness)).size(), 0u);
}

TEST(extract_ridges, scales_with_the_mesh)
{
  const Mesh mesh = ellipsoid(3, 2, 1.4, 1);
  const auto here = ridges(mesh, estimated(mesh, 0.5), params::geodesic_radius(0.5));
  ASSERT_FALSE(here.empty());
  for(double scale : {std::pow(2, -100), std::pow(2, 100)})
  {
    const Mesh there = meshes::moved(mesh, [&](const Vector& p) { return Vector(scale * p); });
    const auto lines = ridges(there, estimated(there, 0.5 * scale), params::geodesic_radius(0.5 * scale));
    ASSERT_EQ(lines.size(), here.size());
    EXPECT_NEAR(length(lines[0]) / scale, length(here[0]), 1e-9);
    EXPECT_NEAR(lines[0].strength, here[0].strength, 1e-9);
    EXPECT_NEAR(lines[0].sharpness, here[0].sharpness, 1e-9);
  }
}

TEST(extract_ridges, finds_none_on_a_mesh_without_a_length_to_go_by)
{
  Mesh mesh = meshes::icosphere<Mesh>(1);
  const Estimates estimates = estimated(mesh, 0.5);
  for(const double length : {0., 1e308}) // four times the mean edge is zero, or beyond all numbers
  {
    for(Vertex v : mesh.vertices())
      mesh.point(v) = Kernel::Point_3(v.idx() % 2 * length, 0, 0);
    EXPECT_TRUE(ridges(mesh, estimates).empty());
  }
}

TEST(extract_ridges, refuses_what_it_cannot_work_with)
{
  const Mesh mesh = meshes::icosphere<Mesh>(1);
  const auto estimates = estimated(mesh, 0.5);
  expect_refused([&] { ridges(mesh, estimates, params::minimum_strength(-1.)); }, {"minimum_strength is -1", "give"});
  expect_refused([&] { ridges(mesh, estimates, params::minimum_sharpness(-1.)); }, {"minimum_sharpness is -1", "give"});
  expect_refused([&] { ridges(mesh, estimates, params::geodesic_radius(-1.)); }, {"geodesic_radius is -1"});
  EXPECT_TRUE(ridges(Mesh(), Estimates()).empty());
  Mesh cube;
  CGAL::make_hexahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                        Kernel::Point_3(0, 1, 0), Kernel::Point_3(0, 1, 1), Kernel::Point_3(0, 0, 1),
                        Kernel::Point_3(1, 0, 1), Kernel::Point_3(1, 1, 1), cube);
  Estimates none;
  for(Vertex v : cube.vertices())
    none[v] = Estimate();
  expect_refused([&] { ridges(cube, none); }, {"not a triangle", "triangulate_faces()"});
}
