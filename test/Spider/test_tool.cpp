// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The parts of the program spider. What the whole of it does is tested by tool_runs.cmake.

#include "Jet_estimator.h"
#include "VTP_writer.h"
#include "colour.h"
#include "command_line.h"
#include "for_each_vertex.h"
#include "read_mesh.h"
#include "read_numbers.h"
#include "statistics.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <sstream>

namespace {

namespace tool = CGAL::Spider::tool;
using tool::Kernel;
using tool::Mesh;
using tool::Vertex;

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

// a grid of the unit square lifted to the sphere of radius 2 around (1/2, 1/2, -2), its faces counterclockwise from
// above
Mesh spherical_cap()
{
  constexpr int n = 16;
  Mesh mesh;
  const auto on_sphere = [](const Kernel::Point_3& p) {
    const double x = p.x() - 0.5, y = p.y() - 0.5;
    return Kernel::Point_3(p.x(), p.y(), std::sqrt(4 - x * x - y * y) - 2);
  };
  const auto point = [&](std::size_t i, std::size_t j) {
    return on_sphere(Kernel::Point_3(double(i) / n, double(j) / n, 0));
  };
  CGAL::make_grid(n, n, mesh, point, true);
  return mesh;
}

Vertex vertex_nearest_to(const Mesh& mesh, const Kernel::Point_3& p)
{
  return *std::min_element(mesh.vertices().begin(), mesh.vertices().end(), [&](Vertex v, Vertex w) {
    return CGAL::squared_distance(mesh.point(v), p) < CGAL::squared_distance(mesh.point(w), p);
  });
}

std::string written_file(const std::string& name, const std::string& content)
{
  const std::string path = testing::TempDir() + name;
  std::ofstream(path) << content;
  return path;
}

std::string refusal(const std::string& file)
{
  try
  {
    tool::read_mesh(file);
  }
  catch(const tool::Unusable_mesh& reason)
  {
    return reason.what();
  }
  return "";
}

TEST(Tool_jets, have_spiders_signs)
{
  // The fit's own error at this radius is that of a quadratic on an arc of 0.15 radians, (r/R)^2 of the curvature.
  Mesh mesh = spherical_cap();
  const Vertex centre = vertex_nearest_to(mesh, {0.5, 0.5, 0});
  const std::vector<double> radii(mesh.num_vertices(), 0.3);
  const auto convex = tool::Jet_estimator(mesh, radii)(centre);
  EXPECT_NEAR(convex.min_curvature, 0.5, 0.5 * 0.0225);
  EXPECT_NEAR(convex.max_curvature, 0.5, 0.5 * 0.0225);
  EXPECT_LE(convex.min_curvature, convex.max_curvature);

  CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh);
  const auto concave = tool::Jet_estimator(mesh, radii)(centre);
  EXPECT_DOUBLE_EQ(concave.min_curvature, -convex.max_curvature);
  EXPECT_DOUBLE_EQ(concave.max_curvature, -convex.min_curvature);
}

TEST(Tool_jets, take_connected_vertices_within_the_radius)
{
  Mesh mesh = spherical_cap();
  const Vertex centre = vertex_nearest_to(mesh, {0.5, 0.5, 0});
  const double radius = 0.2;
  std::size_t within = 0;
  for(Vertex v : mesh.vertices())
    within += CGAL::squared_distance(mesh.point(v), mesh.point(centre)) <= radius * radius;
  mesh.add_vertex(mesh.point(centre)); // near, but not connected

  std::vector<Kernel::Point_3> points;
  for(int repeat = 0; repeat < 2; ++repeat)
  {
    tool::collect_connected_points(centre, mesh, radius, points);
    EXPECT_EQ(points.size(), within);
    EXPECT_EQ(points.front(), mesh.point(centre));
  }
}

TEST(Tool_jets, say_nan_where_points_are_too_few)
{
  Mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, mesh);
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(2, 2, 2));
  const std::vector<double> radii(mesh.num_vertices(), 10);
  const tool::Jet_estimator jets(mesh, radii);
  for(Vertex v : mesh.vertices())
    EXPECT_TRUE(std::isnan(jets(v).mean_curvature())) << v;
  EXPECT_TRUE(std::isnan(jets(isolated).max_curvature));
}

TEST(Tool_for_each_vertex, visits_every_vertex_once)
{
  for(std::size_t n : {0, 1, 49, 50, 1234})
  {
    std::vector<Vertex> vertices;
    for(std::size_t i = 0; i < n; ++i)
      vertices.emplace_back(i);
    std::vector<std::atomic<int>> visits(n);
    testing::internal::CaptureStderr();
    EXPECT_GE(tool::for_each_vertex(vertices, "title", [&] { return [&](Vertex v) { ++visits[v]; }; }), 0);
    EXPECT_EQ(testing::internal::GetCapturedStderr().find("title"), 0u);
    EXPECT_TRUE(std::all_of(visits.begin(), visits.end(), [](int count) { return count == 1; })) << n;
  }
}

TEST(Tool_for_each_vertex, is_silent_without_a_title)
{
  testing::internal::CaptureStderr();
  tool::for_each_vertex({Vertex(0)}, "", [] { return [](Vertex) {}; });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Tool_statistics, quantiles_interpolate_and_leave_nan_out)
{
  const auto sorted = tool::sorted_numbers({4, nan_value, 1, 3, 2});
  ASSERT_EQ(sorted, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_DOUBLE_EQ(tool::quantile(sorted, 0), 1);
  EXPECT_DOUBLE_EQ(tool::quantile(sorted, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(tool::quantile(sorted, 1), 4);
  EXPECT_TRUE(std::isnan(tool::quantile({}, 0.5)));
}

TEST(Tool_statistics, agreement_counts_places_where_both_give_a_number)
{
  const auto same_but_shifted = tool::agreement({1, 2, 3, nan_value, 5}, {1.5, 2.5, 3.5, 4, nan_value});
  EXPECT_DOUBLE_EQ(same_but_shifted.median_difference, 0.5);
  EXPECT_DOUBLE_EQ(same_but_shifted.large_difference, 0.5);
  EXPECT_DOUBLE_EQ(same_but_shifted.correlation, 1);
  EXPECT_DOUBLE_EQ(tool::agreement({1, 2, 3}, {3, 2, 1}).correlation, -1);
}

TEST(Tool_colour, diverges_from_white)
{
  using CGAL::IO::Color;
  EXPECT_EQ(tool::diverging_colour(0, 2), Color(247, 247, 247));
  EXPECT_EQ(tool::diverging_colour(2, 2), Color(178, 24, 43));
  EXPECT_EQ(tool::diverging_colour(1e9, 2), Color(178, 24, 43));
  EXPECT_EQ(tool::diverging_colour(-2, 2), Color(33, 102, 172));
  EXPECT_EQ(tool::diverging_colour(1, 2), Color(244, 165, 130));
  EXPECT_EQ(tool::diverging_colour(nan_value, 2), Color(64, 64, 64));
  EXPECT_EQ(tool::diverging_colour(0, 0), Color(247, 247, 247));
}

TEST(Tool_vtp_writer, pads_base_64_as_its_length_asks_for)
{
  // a length of eight bytes, then the bytes: by Python's base64 module
  const std::vector<std::pair<std::vector<unsigned char>, std::string>> cases = {{{}, ">AAAAAAAAAAA=<"},
                                                                                 {{1}, ">AQAAAAAAAAAB<"},
                                                                                 {{1, 2}, ">AgAAAAAAAAABAg==<"},
                                                                                 {{1, 2, 255}, ">AwAAAAAAAAABAv8=<"}};
  for(const auto& [bytes, expected] : cases)
  {
    std::ostringstream out;
    tool::VTP_writer(out, 0, 0, 0).array("bytes", bytes);
    EXPECT_NE(out.str().find(expected), std::string::npos) << out.str();
  }
}

TEST(Tool_vtp_writer, closes_what_it_opens)
{
  std::ostringstream out;
  tool::VTP_writer(out, 0, 0, 0).open("PointData");
  EXPECT_NE(out.str().find("</PointData>\n</Piece>\n</PolyData>\n</VTKFile>\n"), std::string::npos) << out.str();
}

TEST(Tool_manual_page, has_every_option_that_the_help_has)
{
  CLI::App app;
  tool::Settings settings;
  tool::describe_command_line(app, settings);
  const std::string page = tool::manual_page(app);
  for(const CLI::Option* option : app.get_options())
    for(const std::string& name : option->get_lnames())
    {
      std::string in_page = "\\-\\-";
      for(char c : name)
        in_page += c == '-' ? "\\-" : std::string(1, c);
      EXPECT_NE(page.find(in_page), std::string::npos) << name;
    }
}

TEST(Tool_read_mesh, triangulates_polygons)
{
  const auto mesh = tool::read_mesh(written_file("quad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"));
  EXPECT_EQ(mesh.number_of_vertices(), 4u);
  EXPECT_EQ(mesh.number_of_faces(), 2u);
}

TEST(Tool_read_mesh, joins_the_triangles_of_an_stl_file)
{
  const auto mesh = tool::read_mesh(written_file("two.stl", R"(solid two
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 1 1 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 1 0
vertex 0 1 0
endloop
endfacet
endsolid two
)"));
  EXPECT_EQ(mesh.number_of_vertices(), 4u);
  EXPECT_EQ(mesh.number_of_faces(), 2u);
  EXPECT_EQ(mesh.number_of_edges(), 5u);
}

TEST(Tool_read_mesh, turns_faces_to_agree)
{
  const auto mesh =
    tool::read_mesh(written_file("turned.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 3 2\n"));
  EXPECT_EQ(mesh.number_of_vertices(), 4u);
  EXPECT_EQ(mesh.number_of_edges(), 5u);
}

TEST(Tool_read_mesh, gives_parts_that_meet_at_a_vertex_one_each)
{
  const auto mesh = tool::read_mesh(
    written_file("touching.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n"));
  EXPECT_TRUE(mesh.is_valid());
  EXPECT_EQ(mesh.number_of_vertices(), 6u);
  EXPECT_EQ(mesh.number_of_edges(), 6u);
}

// two triangles, in all formats with the same normals
const std::vector<Kernel::Vector_3> normals_of_square = {{0, 0, 1}, {0, 0.5, 1}, {0.25, 0, 1}, {0, 0, -2}};
const std::string square_as_noff = "NOFF\n4 2 0\n0 0 0 0 0 1\n1 0 0 0 0.5 1\n1 1 0 0.25 0 1\n0 1 0 0 0 -2\n"
                                   "3 0 1 2\n3 0 2 3\n";
const std::string header_of_ply = "ply\nformat ascii 1.0\nelement vertex 4\n"
                                  "property float x\nproperty float y\nproperty float z\n";
const std::string faces_of_ply = "element face 2\nproperty list uchar int vertex_indices\nend_header\n";

TEST(Tool_read_vertex_normals, reads_off_and_ply)
{
  const std::string ply = header_of_ply + "property double nx\nproperty double ny\nproperty double nz\n" +
                          faces_of_ply + "0 0 0 0 0 1\n1 0 0 0 0.5 1\n1 1 0 0.25 0 1\n0 1 0 0 0 -2\n3 0 1 2\n3 0 2 3\n";
  for(const std::string& file : {written_file("normals.off", square_as_noff), written_file("normals.ply", ply)})
    EXPECT_EQ(tool::read_vertex_normals(file, tool::read_mesh(file)), normals_of_square) << file;
}

TEST(Tool_read_vertex_normals, adds_those_of_points_that_become_one)
{
  // The square's diagonal is there twice, and a third face is to be turned: without that the file would be left as it
  // is.
  const std::string file = written_file("doubled.off", "NOFF\n7 3 0\n0 0 0 0 0 1\n1 0 0 0 0 3\n1 1 0 1 0 1\n"
                                                       "0 0 0 0 1 1\n1 1 0 0 0 1\n0 1 0 0 0 5\n1 -1 0 0 0 7\n"
                                                       "3 0 1 2\n3 3 4 5\n3 0 1 6\n");
  const Mesh mesh = tool::read_mesh(file);
  ASSERT_EQ(mesh.number_of_vertices(), 5u);
  const auto normals = tool::read_vertex_normals(file, mesh);
  const auto normal_at = [&](double x, double y) { return normals[vertex_nearest_to(mesh, {x, y, 0})]; };
  EXPECT_EQ(normal_at(0, 0), Kernel::Vector_3(0, 1, 2));
  EXPECT_EQ(normal_at(1, 1), Kernel::Vector_3(1, 0, 2));
  EXPECT_EQ(normal_at(1, 0), Kernel::Vector_3(0, 0, 3));
  EXPECT_EQ(normal_at(0, 1), Kernel::Vector_3(0, 0, 5));
}

TEST(Tool_read_vertex_normals, refuses_files_without)
{
  const std::string ply = header_of_ply + faces_of_ply + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
  for(const std::string& file : {written_file("plain.ply", ply), written_file("plain.obj", obj)})
    EXPECT_THROW(tool::read_vertex_normals(file, tool::read_mesh(file)), tool::Unusable_mesh) << file;
}

TEST(Tool_read_numbers, reads_text_and_csv)
{
  EXPECT_EQ(tool::read_numbers(written_file("numbers.txt", "1 2.5\ninf\t-3e-2\n")),
            (std::vector<double>{1, 2.5, std::numeric_limits<double>::infinity(), -0.03}));
  const std::string csv = written_file("numbers.csv", "x,radius,y\r\n1,2,3\r\n4,nan,6\r\n");
  const auto radii = tool::read_column(csv, "radius");
  ASSERT_EQ(radii.size(), 2u);
  EXPECT_EQ(radii[0], 2);
  EXPECT_TRUE(std::isnan(radii[1]));
  EXPECT_EQ(tool::read_column(csv, "y"), (std::vector<double>{3, 6})); // the last one, before the end of a line
  EXPECT_EQ(tool::read_indices(written_file("indices.txt", "0 7\n3"), 8), (std::vector<std::size_t>{0, 7, 3}));
}

TEST(Tool_read_numbers, refuses_what_is_none)
{
  EXPECT_THROW(tool::read_numbers(testing::TempDir() + "no-such-file.txt"), std::invalid_argument);
  EXPECT_THROW(tool::read_numbers(written_file("words.txt", "1 two 3")), std::invalid_argument);
  EXPECT_THROW(tool::read_column(written_file("cells.csv", "x,radius\n1\n"), "radius"), std::invalid_argument);
  EXPECT_THROW(tool::read_column(written_file("names.csv", "x,y\n1,2\n"), "radius"), std::invalid_argument);
  for(const char* index : {"-1", "8", "1.5", "nan"})
    EXPECT_THROW(tool::read_indices(written_file("index.txt", index), 8), std::invalid_argument) << index;
}

TEST(Tool_read_mesh, refuses_in_one_line)
{
  const std::string fin = "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 1 4\n";
  const std::string moebius_strip = "OFF\n5 5 0\n0 0 0\n1 0 1\n2 0 0\n2 2 1\n0 2 0\n"
                                    "3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
    {testing::TempDir() + "no-such-file.off", "can't be opened"},
    {written_file("text.off", "no mesh at all"), "can't be read"},
    {written_file("mesh.unknown", "OFF\n"), "can't be read"},
    {written_file("truncated.off", "OFF\n3 1 0\n0 0 0\n1 0"), "can't be read"},
    {written_file("repeated.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 0 1\n"), "has no faces"},
    {written_file("points.off", "OFF\n1 0 0\n0 0 0\n"), "has no faces"},
    {written_file("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"), ""},
    {written_file("moebius_strip.off", moebius_strip), "isn't an orientable manifold"},
    {written_file("fin.off", fin), "isn't an orientable manifold"}};
  for(const auto& [file, reason] : cases)
  {
    const std::string message = refusal(file);
    EXPECT_EQ(message.find(file + ": "), 0u) << file;
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

} // namespace
