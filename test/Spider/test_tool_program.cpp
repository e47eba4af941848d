// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program spider from the outside: values in the files that it writes, and what it says of wrong input.

#include "meshes.h"
#include "read_mesh.h"

#include <CGAL/Spider/classify_vertices.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include <sys/wait.h>

namespace {

namespace tool = CGAL::Spider::tool;
using tool::Mesh;
using tool::Vertex;

constexpr double sphere_radius = 2;

// A folder of this process: the tests run side by side, each in a process of its own.
struct Folder
{
  std::filesystem::path path = testing::TempDir() + "spider-tool-" + std::to_string(::getpid());

  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
};

std::string path(const std::string& name)
{
  static const Folder folder;
  return (folder.path / name).string();
}

std::string content(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string written(const std::string& name, const std::string& text)
{
  std::ofstream(path(name)) << text;
  return path(name);
}

std::string written(const std::string& name, const Mesh& mesh)
{
  CGAL::IO::write_polygon_mesh(path(name), mesh, CGAL::parameters::stream_precision(17));
  return path(name);
}

// 2,562 vertices, of mean edge length 0.14
const std::string& sphere_file()
{
  static const std::string file = written("sphere.off", meshes::icosphere<Mesh>(4, sphere_radius));
  return file;
}

constexpr int cells = 8; // along each edge of the unit cube

const std::string& cube_file()
{
  static const std::string file = written("cube.off", meshes::cube<Mesh>(cells));
  return file;
}

struct Outcome
{
  int exit_code;
  std::string out, err;

  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

Outcome spider(const std::string& arguments)
{
  const std::string out = path("stdout"), err = path("stderr");
  const int status = std::system((SPIDER_TOOL " " + arguments + " >" + out + " 2>" + err).c_str());
  return {WEXITSTATUS(status), content(out), content(err)};
}

// one row of numbers for each vertex, by column
std::map<std::string, std::vector<double>> read_csv(const std::string& file)
{
  std::ifstream in(file);
  std::string line, word;
  std::getline(in, line);
  std::vector<std::string> names;
  for(std::istringstream words(line); std::getline(words, word, ',');)
    names.push_back(word);
  std::map<std::string, std::vector<double>> columns;
  while(std::getline(in, line))
  {
    std::istringstream words(line);
    for(const std::string& name : names)
    {
      std::getline(words, word, ',');
      columns[name].push_back(std::strtod(word.c_str(), nullptr));
    }
  }
  return columns;
}

TEST(Tool_program, writes_the_curvature_of_a_sphere_as_csv)
{
  const std::string csv = path("sphere.csv");
  ASSERT_EQ(spider(sphere_file() + " --quiet --radius-in-edges 3 --output " + csv).exit_code, 0);
  auto columns = read_csv(csv);
  ASSERT_EQ(columns["H"].size(), 2562u);
  for(std::size_t i = 0; i < columns["H"].size(); ++i)
  {
    // the measured worst is 1.2 %: the bias of a quadric at r/R = 0.21, and the facets'
    EXPECT_NEAR(columns["H"][i], 1 / sphere_radius, 0.02 / sphere_radius);
    EXPECT_NEAR(columns["K"][i], columns["k_min"][i] * columns["k_max"][i], 1e-14);
    EXPECT_LE(columns["k_min"][i], columns["k_max"][i]);
    double along_normal = 0;
    for(const char* axis : {"x", "y", "z"})
    {
      EXPECT_NEAR(columns[std::string("normal_") + axis][i], columns[axis][i] / sphere_radius, 0.01);
      along_normal += columns[std::string("normal_") + axis][i] * columns[std::string("max_direction_") + axis][i];
    }
    EXPECT_NEAR(along_normal, 0, 1e-12);
    EXPECT_EQ(columns["status"][i], 0);
    EXPECT_EQ(columns["coverage"][i], 1);
  }
}

TEST(Tool_program, writes_ply_that_cgal_reads_back)
{
  const std::string ply = path("sphere.ply"), csv = path("same.csv");
  ASSERT_EQ(spider(sphere_file() + " -q --geodesic-radius 0.5 --labels -o " + ply).exit_code, 0);
  ASSERT_EQ(spider(sphere_file() + " -q --geodesic-radius 0.5 --labels -o " + csv).exit_code, 0);
  Mesh mesh;
  std::string comments;
  std::ifstream in(ply, std::ios::binary);
  ASSERT_TRUE(CGAL::IO::read_PLY(in, mesh, comments));
  EXPECT_NE(comments.find("vertex colour: H from -0.5"), std::string::npos) << comments;
  auto columns = read_csv(csv);
  const auto H = mesh.add_property_map<Vertex, double>("v:H").first; // finds the one that is there
  const auto radius = mesh.add_property_map<Vertex, double>("v:radius").first;
  const auto label = mesh.add_property_map<Vertex, std::uint8_t>("v:label", 9).first;
  for(Vertex v : mesh.vertices())
  {
    EXPECT_EQ(H[v], columns["H"][v]);
    EXPECT_EQ(radius[v], 0.5);
    EXPECT_EQ(label[v], CGAL::Spider::convex);
  }
}

TEST(Tool_program, names_columns_by_radius)
{
  const std::string csv = path("radii.csv");
  const auto outcome = spider(sphere_file() + " -q --json --radius-in-edges 2,3.5 -o " + csv);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  auto columns = read_csv(csv);
  ASSERT_EQ(columns.count("H_r2a"), 1u);
  ASSERT_EQ(columns.count("H_r3.5a"), 1u);
  EXPECT_NEAR(columns["radius_r3.5a"][0] / columns["radius_r2a"][0], 3.5 / 2, 1e-12);
  EXPECT_EQ(outcome.json()["runs"].size(), 2u);
}

TEST(Tool_program, takes_the_parameters)
{
  const auto median_H = [](const std::string& options) {
    const auto outcome = spider(sphere_file() + " -q --json --geodesic-radius 0.8 " + options);
    EXPECT_EQ(outcome.exit_code, 0) << options << outcome.err;
    return outcome.json()["runs"][0]["H"]["median"].get<double>();
  };
  const double plain = median_H("");
  const double published = median_H("--as-published");
  EXPECT_NE(plain, published);
  EXPECT_EQ(published, median_H("--estimator section_fit --limb-measure arc_length --number-of-directions 64 "
                                "--first-normal sphere_section --resampling-step 0.1 --polynomial-degree 2 "
                                "--number-of-iterations 10 --convergence-angle 0.001 --minimum-crossing-angle 30"));
  EXPECT_NE(published, median_H("--as-published --number-of-directions 8"));
  EXPECT_NE(published, median_H("--as-published --resampling-step 0.5"));
  EXPECT_NE(published, median_H("--as-published --limb-measure tangential_distance"));
  const double quartic = median_H("--polynomial-degree 4");
  EXPECT_NE(plain, quartic);
  EXPECT_NEAR(quartic, 1 / sphere_radius, 0.01 / sphere_radius); // measured 0.3 %
}

TEST(Tool_program, keeps_patches_apart_at_features)
{
  const std::string csv = path("cube.csv");
  const auto outcome = spider(cube_file() + " -q --json --geodesic-radius 0.3 --feature-angle 40 --output " + csv);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.json()["mesh"]["feature_edges"], 12 * cells);
  for(double H : read_csv(csv)["H"])
    EXPECT_NEAR(H, 0, 1e-10);
  const auto without = spider(cube_file() + " -q --json --geodesic-radius 0.3");
  EXPECT_GT(without.json()["runs"][0]["H"]["p95"], 1); // the edges' curvature is about 1 / r
}

TEST(Tool_program, heeds_growth_costs)
{
  const std::string free = written("costs-1.txt", [] {
    std::string ones;
    for(int i = 0; i < 6 * cells * cells * 2; ++i)
      ones += "1 ";
    return ones;
  }());
  const std::string forbidden = written("costs-inf.txt", std::regex_replace(content(free), std::regex("1"), "inf"));
  const std::string run = cube_file() + " -q --json --geodesic-radius 0.2 --growth-costs ";
  EXPECT_EQ(spider(run + free).json()["runs"][0]["H"],
            spider(cube_file() + " -q --json --geodesic-radius 0.2").json()["runs"][0]["H"]);
  EXPECT_EQ(spider(run + forbidden).json()["runs"][0]["vertices"]["ok"], 0);
}

// the numbers of an edge's vertices, a line for each edge of the unit cube's own
std::string edges_of_cube(const Mesh& mesh)
{
  const auto is_side = [](double x, double y) { return x == y && (x == 0 || x == 1); };
  std::string text;
  for(auto e : mesh.edges())
  {
    const auto p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    if(is_side(p.x(), q.x()) + is_side(p.y(), q.y()) + is_side(p.z(), q.z()) == 2)
      text += std::to_string(mesh.vertex(e, 0).idx()) + " " + std::to_string(mesh.vertex(e, 1).idx()) + "\n";
  }
  return text;
}

TEST(Tool_program, takes_feature_edges_from_a_file)
{
  const std::string file = written("edges.txt", edges_of_cube(tool::read_mesh(cube_file())));
  const std::string csv = path("constrained.csv");
  const auto outcome =
    spider(cube_file() + " -q --json --geodesic-radius 0.3 --constrained-edges " + file + " --output " + csv);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.json()["mesh"]["feature_edges"], 12 * cells);
  for(double H : read_csv(csv)["H"])
    EXPECT_NEAR(H, 0, 1e-10);
  const auto kept = spider(cube_file() + " -q --json --smooth 3 --constrained-edges " + file);
  EXPECT_LT(kept.json()["smoothing"]["greatest_displacement"], 1e-12);
}

TEST(Tool_program, starts_from_the_normals_in_the_file)
{
  // Normals that are off by 0.3 radians, and one round, which doesn't mend them: then they are in the answer.
  const Mesh mesh = tool::read_mesh(sphere_file());
  std::vector<tool::Kernel::Vector_3> normals;
  std::ostringstream noff;
  noff.precision(17);
  noff << "NOFF\n" << mesh.number_of_vertices() << ' ' << mesh.number_of_faces() << " 0\n";
  for(Vertex v : mesh.vertices())
  {
    const auto p = mesh.point(v) - CGAL::ORIGIN;
    normals.push_back(p + 0.3 * CGAL::cross_product(tool::Kernel::Vector_3(1, 0, 0), p));
    noff << mesh.point(v) << ' ' << normals.back() << '\n';
  }
  for(auto f : mesh.faces())
  {
    noff << 3;
    for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      noff << ' ' << v.idx();
    noff << '\n';
  }
  const std::string csv = path("normals.csv");
  const std::string run = written("normals.off", noff.str()) +
                          " -q --estimator section_fit --number-of-iterations 1 --geodesic-radius 0.5 -o " + csv;
  ASSERT_EQ(spider(run).exit_code, 0);
  const auto without = read_csv(csv).at("H");
  ASSERT_EQ(spider(run + " --vertex-normals").exit_code, 0);
  const auto with = read_csv(csv).at("H");

  std::vector<tool::Estimate> expected(mesh.number_of_vertices());
  CGAL::Spider::estimate_vertex_curvatures(
    mesh, tool::Array_map<Vertex, tool::Estimate>{expected.data()},
    CGAL::Spider::parameters::geodesic_radius(0.5)
      .estimator(CGAL::Spider::section_fit)
      .number_of_iterations(1)
      .vertex_normal_map(tool::Array_map<Vertex, const tool::Kernel::Vector_3>{normals.data()}));
  for(Vertex v : mesh.vertices())
    EXPECT_EQ(with[v], expected[v].mean_curvature());
  EXPECT_NE(with, without);
}

TEST(Tool_program, takes_a_radius_for_each_vertex)
{
  const auto run = [](const std::string& options) {
    const std::string csv = path("by-vertex.csv");
    EXPECT_EQ(spider(sphere_file() + " -q -o " + csv + " " + options).exit_code, 0) << options;
    return read_csv(csv);
  };
  std::string radii;
  for(int v = 0; v < 2562; ++v)
    radii += v % 2 == 0 ? "0.5\n" : "0.8\n";
  // by faces' normals, which a neighbour's radius has no part in
  const std::string first_normal = " --first-normal incident_faces";
  auto mixed = run("--radius-by-vertex " + written("radii.txt", radii) + first_normal);
  auto small = run("--geodesic-radius 0.5" + first_normal), large = run("--geodesic-radius 0.8" + first_normal);
  for(std::size_t v = 0; v < mixed["H"].size(); ++v)
  {
    EXPECT_EQ(mixed["radius"][v], v % 2 == 0 ? 0.5 : 0.8);
    EXPECT_EQ(mixed["H"][v], (v % 2 == 0 ? small : large)["H"][v]);
  }
  EXPECT_NE(small["H"], large["H"]);

  const auto suggested = run("--suggest-radius-by-vertex");
  const std::string csv = written("radii.csv", content(path("by-vertex.csv")));
  EXPECT_EQ(run("--radius-by-vertex " + csv), suggested);
}

TEST(Tool_program, suggests_a_radius)
{
  const auto one = spider(sphere_file() + " -q --json --suggest-radius").json()["runs"][0]["radius"];
  EXPECT_EQ(one["least"], one["greatest"]);
  EXPECT_GE(one["least"], 2 * 0.13); // of 2 to 16 edges
  EXPECT_LE(one["least"], 16 * 0.15);
  const auto many = spider(sphere_file() + " -q --json --suggest-radius-by-vertex").json()["runs"][0]["radius"];
  EXPECT_LT(many["least"], many["greatest"]);
  const auto adaptive = spider(sphere_file() + " -q --json --suggest-adaptive-radii").json()["runs"][0]["radius"];
  EXPECT_LT(adaptive["least"], adaptive["greatest"]);
  EXPECT_GE(adaptive["least"], 2 * 0.13); // of 2 to 8 edges
  EXPECT_LE(adaptive["greatest"], 8 * 0.16);
  const auto limbs = spider(sphere_file() + " -q --json --suggest-adaptive-limbs").json()["runs"][0]["radius"];
  EXPECT_GE(limbs["greatest"], adaptive["greatest"]); // of ellipses, their longer axes
}

TEST(Tool_program, draws_isolines)
{
  const std::string obj = path("lines.obj"), vtp = path("lines.vtp");
  const auto outcome = spider(cube_file() +
                              " -q --json --geodesic-radius 0.3 --isolines H=1,k_max=0.5 "
                              "--isolines-output " +
                              obj);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto lines = outcome.json()["isolines"];
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0]["lines"], 6);            // one around each face
  EXPECT_GT(lines[0]["length"], 6 * 4 * 0.4); // somewhere within the radius of its edges
  EXPECT_LT(lines[0]["length"], 6 * 4 * 1.0);
  const std::string text = content(obj);
  const std::regex line("(^|\n)l ");
  EXPECT_EQ(std::distance(std::sregex_iterator(text.begin(), text.end(), line), {}),
            lines[0]["lines"].get<int>() + lines[1]["lines"].get<int>());
  ASSERT_EQ(spider(cube_file() + " -q --geodesic-radius 0.3 --isolines H=1 --isolines-output " + vtp).exit_code, 0);
  EXPECT_NE(content(vtp).find("NumberOfLines=\"6\""), std::string::npos);
}

double perimeter_of_ellipse(double a, double b) // Ramanujan's, good to nine digits here
{
  const double h = (a - b) * (a - b) / ((a + b) * (a + b));
  return meshes::pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
}

TEST(Tool_program, draws_ridges)
{
  Mesh ellipsoid = meshes::icosphere<Mesh>(4);
  for(Vertex v : ellipsoid.vertices())
  {
    const auto p = ellipsoid.point(v);
    ellipsoid.point(v) = {2 * p.x(), 1.4 * p.y(), p.z()};
  }
  const std::string obj = path("ridges.obj"), vtp = path("ridges.vtp");
  const std::string run = written("ellipsoid.off", ellipsoid) + " -q --json --geodesic-radius 0.3 --ridges ";
  const auto outcome = spider(run + obj);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto ridges = outcome.json()["ridges"], valleys = outcome.json()["valleys"];
  EXPECT_EQ(ridges["lines"], 1); // around the middle, across the short axis
  EXPECT_EQ(valleys["lines"], 0);
  const double length = ridges["length"], strength = ridges["strength"];
  EXPECT_NEAR(length, perimeter_of_ellipse(2, 1.4), 0.02); // of edges of 0.1, whose square is 0.01
  EXPECT_GT(strength, 1.4 * length);                       // the curvature across, at its least
  EXPECT_LT(strength, 2 * length);                         // and at its greatest

  std::istringstream lines(content(obj));
  std::string word;
  std::vector<std::string> indices;
  for(std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    words >> word;
    if(word == "v")
    {
      double x, y, z;
      words >> x >> y >> z;
      EXPECT_NEAR(z, 0, 1e-4); // measured: 1e-6
    }
    else if(word == "l")
      indices.assign(std::istream_iterator<std::string>(words), {});
  }
  EXPECT_EQ(content(obj).rfind("g ridges\n", 0), 0u);
  ASSERT_GT(indices.size(), 2u);
  EXPECT_EQ(indices.front(), indices.back()); // closed

  ASSERT_EQ(spider(run + vtp).exit_code, 0);
  EXPECT_NE(content(vtp).find("NumberOfLines=\"1\""), std::string::npos);
  for(const char* name : {"strength", "sharpness", "kind"})
    EXPECT_NE(content(vtp).find("Name=\"" + std::string(name) + "\""), std::string::npos) << name;
  std::ostringstream above;
  above << " --minimum-strength " << 1.01 * strength;
  EXPECT_EQ(spider(run + vtp + above.str()).json()["ridges"]["lines"], 0);
  EXPECT_EQ(spider(run + vtp + " --minimum-sharpness 100").json()["ridges"]["lines"], 0);
}

TEST(Tool_program, draws_limbs_and_rings)
{
  const std::string obj = path("limbs.obj"), vtp = path("limbs.vtp");
  const std::string run = cube_file() + " -q --geodesic-radius 0.3 --limb-measure arc_length --number-of-directions 4";
  const Mesh mesh = tool::read_mesh(cube_file());
  const Vertex top = *std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                                   [&](Vertex v) { return mesh.point(v) == tool::Kernel::Point_3(0.5, 0.5, 1); });
  const std::string limbs = " --limbs " + std::to_string(top.idx()) + " --limbs-output ";
  ASSERT_EQ(spider(run + limbs + obj).exit_code, 0);
  std::istringstream lines(content(obj));
  std::map<std::string, int> count; // of lines by group
  std::string word, group;
  std::vector<tool::Kernel::Point_3> points;
  while(lines >> word)
    if(word == "g")
      lines >> group;
    else if(word == "l")
      ++count[group];
    else if(word == "v")
    {
      tool::Kernel::Point_3 p;
      lines >> p;
      points.push_back(p);
    }
  EXPECT_EQ(count, (std::map<std::string, int>{{"limbs", 8}, {"rings", 1}}));
  for(std::size_t i = points.size() - 8; i < points.size(); ++i) // the ring is a circle on the cube's upper side
    EXPECT_NEAR(CGAL::squared_distance(points[i], mesh.point(top)), 0.3 * 0.3, 1e-12);
  ASSERT_EQ(spider(run + limbs + vtp).exit_code, 0);
  EXPECT_NE(content(vtp).find("NumberOfLines=\"9\""), std::string::npos);
}

TEST(Tool_program, smooths)
{
  const std::string off = path("smooth.off");
  const auto outcome = spider(cube_file() + " -q --json --smooth 3 --smoothing-factor 0.5 --mesh-output " + off);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto done = outcome.json()["smoothing"];
  EXPECT_EQ(done["rounds"], 3);
  EXPECT_NEAR(done["volume_after"], done["volume_before"], 1e-6);
  const Mesh cube = tool::read_mesh(cube_file()), smooth = tool::read_mesh(off);
  double greatest = 0;
  for(Vertex v : cube.vertices())
    greatest = std::max(greatest, std::sqrt(CGAL::squared_distance(cube.point(v), smooth.point(v))));
  EXPECT_NEAR(greatest, done["greatest_displacement"], 1e-12);
  EXPECT_GT(greatest, 0.01);
  const auto kept = spider(cube_file() + " -q --json --smooth 3 --feature-angle 40");
  EXPECT_LT(kept.json()["smoothing"]["greatest_displacement"], 1e-12);
}

TEST(Tool_program, keeps_constrained_vertices_while_smoothing)
{
  const std::string off = path("constrained.off");
  const auto outcome = spider(cube_file() + " -q --json --smooth 3 --constrained-vertices " +
                              written("vertices.txt", "0 5\n17") + " --mesh-output " + off);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Mesh cube = tool::read_mesh(cube_file()), smooth = tool::read_mesh(off);
  for(std::size_t v : {0, 5, 17}) // on an edge of the cube, where the others move
    EXPECT_EQ(smooth.point(Vertex(v)), cube.point(Vertex(v))) << v;
  EXPECT_GT(CGAL::squared_distance(smooth.point(Vertex(1)), cube.point(Vertex(1))), 1e-6);
}

TEST(Tool_program, smooths_by_rings_as_told)
{
  const auto displacement = [](const std::string& options) {
    const auto outcome = spider(cube_file() + " -q --json --smooth 2 " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.json()["smoothing"]["mean_displacement"].get<double>();
  };
  const double plain = displacement("");
  EXPECT_EQ(plain, displacement("--smoothing-directions 16 --smoothing-limb-measure arc_length"));
  EXPECT_NE(plain, displacement("--smoothing-directions 4"));
  EXPECT_NE(plain, displacement("--smoothing-limb-measure tangential_distance"));
}

TEST(Tool_program, is_quiet_if_asked)
{
  const auto quiet = spider(sphere_file() + " --quiet");
  EXPECT_EQ(quiet.out + quiet.err, "");
  const auto loud = spider(sphere_file());
  EXPECT_NE(loud.out.find("vertices ok"), std::string::npos);
  EXPECT_NE(loud.err.find("100%"), std::string::npos);
}

TEST(Tool_program, says_one_line_about_what_is_wrong)
{
  const std::string sphere = sphere_file();
  const std::vector<std::tuple<std::string, int, std::string>> cases = {
    {path("no-such-file.off"), 1, "can't be opened"},
    {written("text.off", "no mesh at all"), 1, "can't be read"},
    {written("point.off", "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n"), 1, "no edges of positive, finite length"},
    {"", 2, "mesh is required"},
    {sphere + " --no-such-option", 2, "no-such-option"},
    {sphere + " --geodesic-radius -1", 2, "-1 is no positive number"},
    {sphere + " --geodesic-radius 1 --suggest-radius", 2, "excludes"},
    {sphere + " --geodesic-radius 1,0.5,1", 2, "1 is given twice"},
    {sphere + " --polynomial-degree 7", 2, "polynomial_degree is 7: give 2, 3 or 4"},
    {sphere + " --number-of-directions -3", 2, "number_of_directions is -3"},
    {sphere + " --estimator jets", 2, "surface_fit"},
    {sphere + " --isolines H", 2, "like H=0"},
    {sphere + " --isolines H=up", 2, "finite number"},
    {sphere + " --smoothing-factor 0.3", 2, "--smooth"},
    {sphere + " --smooth 3 --smoothing-factor 2", 2, "smoothing_factor is 2"},
    {sphere + " --labels --flatness-threshold -1", 2, "flatness_threshold is -1"},
    {sphere + " --growth-costs " + written("one.txt", "1"), 2, "give one for each"},
    {sphere + " --growth-costs " + path("no-such-file.txt"), 2, "can't be opened"},
    {sphere + " --vertex-normals", 1, "has no normals of vertices"},
    {sphere + " --radius-by-vertex " + written("one.txt", "1"), 2, "1 numbers for a mesh of 2562 vertices"},
    {written("triangle.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") + " --radius-by-vertex " +
       written("negative.txt", "1 -1 1"),
     2, "-1 is no positive length"},
    {sphere + " --radius-by-vertex " + written("one.txt", "1") + " --suggest-radius", 2, "excludes"},
    {sphere + " --constrained-edges " + written("three.txt", "0 1 2"), 2, "odd number of vertices"},
    {sphere + " --constrained-edges " + written("loop.txt", "0 0"), 2, "the vertices 0 and 0 have no edge"},
    {sphere + " --smooth 1 --constrained-vertices " + written("far.txt", "2562"), 2, "2562 is no vertex"},
    {sphere + " --smooth 1 --smoothing-directions 3", 2, "number_of_directions is 3"},
    {sphere + " --limbs 2562 --limbs-output " + path("x.vtp"), 2, "--limbs has 2562"},
    {sphere + " --limbs 0 --limbs-output " + path("x.csv"), 2, "ends in .vtp or .obj"},
    {sphere + " --minimum-strength 2", 2, "--ridges"},
    {sphere + " --ridges " + path("x.ply"), 2, "ends in .vtp or .obj"},
    {sphere + " --ridges " + path("x.vtp") + " --minimum-strength -2", 2, "minimum_strength is -2"},
    {sphere + " --output " + path("x.xyz"), 2, "ends in .ply, .vtp or .csv"},
    {sphere + " --output " + path("no-such-folder/x.ply"), 3, "can't be written"},
    {sphere + " --picture " + path("no-such-folder/x.png"), 3, "can't be written"}};
  for(const auto& [arguments, exit_code, words] : cases)
  {
    const auto outcome = spider(arguments + " --quiet");
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(outcome.err.rfind("spider: ", 0), 0u) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

} // namespace
