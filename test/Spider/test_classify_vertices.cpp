// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"
#include "tracing.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Spider/classify_vertices.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <limits>
#include <map>
#include <random>
#include <sstream>

using namespace estimation;

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using tracing::expect_refused;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// All that `classify_vertices()` needs of an estimate.
struct Two_curvatures
{
  double min_curvature, max_curvature;
};

template <typename Mesh>
struct Labelled
{
  using Vertex = tracing::Vertex_of<Mesh>;
  std::map<Vertex, Spider::Vertex_label> label;
  double threshold;
};

template <typename Mesh, typename Curvature, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Labelled<Mesh> labelled(const Mesh& mesh, const std::map<tracing::Vertex_of<Mesh>, Curvature>& curvature,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  using Map = std::map<tracing::Vertex_of<Mesh>, Curvature>;
  Labelled<Mesh> result;
  result.threshold = Spider::classify_vertices(mesh, boost::const_associative_property_map<Map>(curvature),
                                               boost::make_assoc_property_map(result.label), np);
  return result;
}

/// returns estimates at the vertices that `classify_vertices()` is to label.
template <typename Mesh, typename NamedParameters>
auto curvatures(const Mesh& mesh, const NamedParameters& np)
{
  std::map<tracing::Vertex_of<Mesh>, Estimate> result;
  Spider::estimate_vertex_curvatures(mesh, boost::make_assoc_property_map(result), np);
  return result;
}

/// returns the label of one vertex with given curvatures.
Spider::Vertex_label label_of(double min_curvature, double max_curvature, double threshold)
{
  const Mesh mesh = meshes::plane<Mesh>(1);
  std::map<Vertex, Two_curvatures> curvature;
  for(Vertex v : mesh.vertices())
    curvature[v] = {min_curvature, max_curvature};
  const auto result = labelled(mesh, curvature, params::flatness_threshold(threshold));
  EXPECT_EQ(result.threshold, threshold);
  return result.label.begin()->second;
}

/// returns the share of the area of a mesh's vertices for which something holds.
template <typename Predicate>
double share_of_area(const Mesh& mesh, Predicate&& holds)
{
  double sum = 0, total = 0;
  for(auto f : mesh.faces())
    for(Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    {
      const double area = PMP::face_area(f, mesh);
      total += area;
      sum += holds(v) ? area : 0;
    }
  return sum / total;
}

/// Finds the vertex of a mesh that is nearest to a point.
class Nearest_vertex
{
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;

public:
  explicit Nearest_vertex(const Mesh& mesh) : tree_(mesh.points().begin(), mesh.points().end())
  {
    for(Vertex v : mesh.vertices())
      vertex_at_[mesh.point(v)] = v;
  }

  Vertex operator()(const Kernel::Point_3& p) const { return vertex_at_.at(Search(tree_, p, 1).begin()->first); }

private:
  Search::Tree tree_;
  std::map<Kernel::Point_3, Vertex> vertex_at_;
};

} // namespace

TEST(classify_vertices, compares_both_principal_curvatures_with_the_threshold)
{
  EXPECT_EQ(label_of(2, 3, 1), Spider::convex);
  EXPECT_EQ(label_of(0, 3, 1), Spider::convex); // a ridge
  EXPECT_EQ(label_of(-0.9, 3, 1), Spider::convex);
  EXPECT_EQ(label_of(-3, -2, 1), Spider::concave);
  EXPECT_EQ(label_of(-3, 0, 1), Spider::concave); // a rut
  EXPECT_EQ(label_of(-3, 0.9, 1), Spider::concave);
  EXPECT_EQ(label_of(-3, 2, 1), Spider::saddle);
  EXPECT_EQ(label_of(-1, 1, 1), Spider::flat);
  EXPECT_EQ(label_of(0, 0, 0), Spider::flat);
  EXPECT_EQ(label_of(-1e-9, 1e-9, 0), Spider::saddle);
  EXPECT_EQ(label_of(not_a_number, 3, 1), Spider::unlabelled);
  EXPECT_EQ(label_of(-std::numeric_limits<double>::infinity(), 3, 1), Spider::unlabelled);
}

TEST(classify_vertices, follows_the_side_to_which_faces_point)
{
  Mesh mesh = meshes::icosphere<Mesh>(3);
  for(const auto& [v, label] : labelled(mesh, curvatures(mesh, params::geodesic_radius(0.5))).label)
    EXPECT_EQ(label, Spider::convex);
  PMP::reverse_face_orientations(mesh);
  for(const auto& [v, label] : labelled(mesh, curvatures(mesh, params::geodesic_radius(0.5))).label)
    EXPECT_EQ(label, Spider::concave);
}

template <typename Mesh>
class Classify_vertices : public ::testing::Test
{};
TYPED_TEST_SUITE(Classify_vertices, tracing::Mesh_types, );

TYPED_TEST(Classify_vertices, takes_three_quarters_of_the_curvature_that_is_everywhere_for_the_threshold)
{
  const auto sphere = meshes::icosphere<TypeParam>(3, 2);
  const auto of_sphere = labelled(sphere, curvatures(sphere, params::geodesic_radius(0.6)));
  EXPECT_NEAR(of_sphere.threshold, 0.75 / 2, 0.02);
  const auto cylinder = meshes::cylinder<TypeParam>(2, 6, 24, 12, meshes::alternating);
  const auto of_cylinder = labelled(cylinder, curvatures(cylinder, params::geodesic_radius(1)));
  EXPECT_NEAR(of_cylinder.threshold, 0.75 / 2, 0.04);
  for(const auto& labels : {of_sphere.label, of_cylinder.label})
    for(const auto& [v, label] : labels)
      EXPECT_EQ(label, Spider::convex);
}

TEST(classify_vertices, tells_the_parts_of_a_wave_apart)
{
  // Ridges along y where cos x = 1, ruts where it is -1, nothing in between; and eggs and saddles in a second wave.
  const auto expect_labels = [](bool is_egg_box, auto&& expected) {
    const Mesh mesh = meshes::height_field<Mesh>(40, meshes::pi / 20, [&](double x, double y) {
      return is_egg_box ? 0.2 * (std::cos(x) + std::cos(y)) : 0.2 * std::cos(x);
    });
    auto result = labelled(mesh, curvatures(mesh, params::geodesic_radius(0.4)));
    for(Vertex v : mesh.vertices())
    {
      const Vector p = meshes::point(mesh, v);
      const auto wanted = expected(std::cos(p.x()), std::cos(p.y()));
      if(wanted != Spider::unlabelled && p.cwiseAbs().maxCoeff() < 6)
      {
        EXPECT_EQ(result.label[v], wanted) << p.transpose();
      }
    }
  };
  constexpr double much = 0.8, little = 0.1;
  expect_labels(false, [](double x, double) {
    return x > much               ? Spider::convex
           : x < -much            ? Spider::concave
           : std::abs(x) < little ? Spider::flat
                                  : Spider::unlabelled;
  });
  expect_labels(true, [](double x, double y) {
    return x > much && y > -little              ? Spider::convex
           : x < -much && y < little            ? Spider::concave
           : x > much && y < -much              ? Spider::saddle
           : std::abs(x) + std::abs(y) < little ? Spider::flat
                                                : Spider::unlabelled;
  });
}

TEST(classify_vertices, scales_with_the_mesh)
{
  const Mesh mesh = meshes::jittered(meshes::torus<Mesh>(1, 0.4, 40, 16), 0.02, 1);
  const auto here = labelled(mesh, curvatures(mesh, params::geodesic_radius(0.3)));
  for(double scale : {std::pow(2, -200), std::pow(2, 200)})
  {
    const Mesh there = meshes::moved(mesh, [&](const Vector& p) { return Vector(scale * p); });
    const auto scaled = labelled(there, curvatures(there, params::geodesic_radius(0.3 * scale)));
    EXPECT_EQ(scaled.label, here.label);
    EXPECT_DOUBLE_EQ(scaled.threshold, here.threshold / scale);
  }
}

TEST(classify_vertices, is_not_moved_by_a_few_wild_estimates_nor_by_how_densely_a_part_is_meshed)
{
  const Mesh mesh = meshes::icosphere<Mesh>(3);
  auto curvature = curvatures(mesh, params::geodesic_radius(0.5));
  const double threshold = labelled(mesh, curvature).threshold;
  std::mt19937 random(1);
  for(Vertex v : mesh.vertices())
    if(random() % 100 < 4)
      curvature[v].max_curvature = 1e12;
  EXPECT_NEAR(labelled(mesh, curvature).threshold, threshold, 0.01 * threshold);

  // Columns ten times as narrow on the right, where the surface is ten times as curved
  const auto x_of = [](int i) { return i < 0 ? i / 10. : i / 100.; };
  const Mesh dense =
    meshes::moved(meshes::plane<Mesh>(100), [&](const Vector& p) { return Vector(x_of(int(p.x())), p.y(), 0); });
  std::map<Vertex, Two_curvatures> given;
  for(Vertex v : dense.vertices())
    given[v] = dense.point(v).x() < 0 ? Two_curvatures{0, 1} : Two_curvatures{0, 10};
  // Where they meet, the vertices have 0.05 of the left.
  const double left = 10 - 0.05, right = 1 + 0.05, trimmed = 0.05 * (left + right);
  const double mean = (left * 1 + (right - trimmed) * 10) / (left + right - trimmed);
  EXPECT_NEAR(labelled(dense, given).threshold, 0.75 * mean, 1e-10);
}

TEST(classify_vertices, takes_a_plane_for_flat_whatever_rounding_does)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector(3, -2, 1).normalized()).toRotationMatrix();
  const Mesh mesh = meshes::moved(meshes::plane<Mesh>(8), [&](const Vector& p) { return Vector(turn * p); });
  for(const auto& [v, label] : labelled(mesh, curvatures(mesh, params::geodesic_radius(2))).label)
    EXPECT_EQ(label, Spider::flat);
}

TEST(classify_vertices, says_where_there_is_no_estimate)
{
  Mesh mesh = meshes::icosphere<Mesh>(2);
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(5, 5, 5));
  auto result = labelled(mesh, curvatures(mesh, params::geodesic_radius(0.5)));
  EXPECT_EQ(result.label[isolated], Spider::unlabelled);
  EXPECT_EQ(result.label[Vertex(0)], Spider::convex);

  Mesh points;
  points.add_vertex(Kernel::Point_3(5, 5, 5));
  result = labelled(points, curvatures(points, params::geodesic_radius(0.5)));
  EXPECT_TRUE(std::isnan(result.threshold));
  EXPECT_EQ(result.label[Vertex(0)], Spider::unlabelled);
  EXPECT_TRUE(std::isnan(labelled(Mesh(), std::map<Vertex, Estimate>()).threshold));
}

TEST(classify_vertices, labels_estimates_on_faces_without_area_too)
{
  const Mesh needle = meshes::from_soup<Mesh>({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  std::map<Vertex, Two_curvatures> curvature;
  for(Vertex v : needle.vertices())
    curvature[v] = {1, 2};
  const auto result = labelled(needle, curvature);
  EXPECT_GT(result.threshold, 0);
  for(const auto& [v, label] : result.label)
    EXPECT_EQ(label, Spider::convex);
}

TEST(classify_vertices, labels_a_scan_alike_before_and_after_remeshing)
{
  Mesh scan;
  if(!meshes::read("bunny00.off", scan))
    GTEST_SKIP() << "no bunny00.off";
  const double edge = meshes::mean_edge_length(scan);
  Mesh remeshed = scan;
  PMP::isotropic_remeshing(remeshed.faces(), edge, remeshed);
  remeshed.collect_garbage();

  const auto np = params::geodesic_radius(4 * edge);
  auto before = labelled(scan, curvatures(scan, np)), after = labelled(remeshed, curvatures(remeshed, np));
  const Nearest_vertex nearest(remeshed);
  const double same =
    share_of_area(scan, [&](Vertex v) { return before.label[v] == after.label[nearest(scan.point(v))]; });
  EXPECT_GT(same, 0.95);
  EXPECT_NEAR(after.threshold, before.threshold, 0.05 * before.threshold);
  for(auto label : {Spider::convex, Spider::concave, Spider::flat, Spider::saddle})
    EXPECT_GT(share_of_area(scan, [&](Vertex v) { return before.label[v] == label; }), 0.02) << label;
}

TEST(classify_vertices, has_a_name_and_a_colour_for_each_label)
{
  std::ostringstream names;
  std::map<std::array<int, 3>, int> colours;
  for(auto label : {Spider::convex, Spider::concave, Spider::flat, Spider::saddle, Spider::unlabelled})
  {
    names << label << ' ';
    const CGAL::IO::Color c = Spider::label_color(label);
    ++colours[{c.red(), c.green(), c.blue()}];
  }
  EXPECT_EQ(names.str(), "convex concave flat saddle unlabelled ");
  EXPECT_EQ(colours.size(), 5u);
}

TEST(classify_vertices, refuses_what_it_cannot_work_with)
{
  const Mesh mesh = meshes::icosphere<Mesh>(1);
  const auto curvature = curvatures(mesh, params::geodesic_radius(0.5));
  expect_refused([&] { labelled(mesh, curvature, params::flatness_threshold(-1)); },
                 {"flatness_threshold is -1", "give"});
  expect_refused([&] { labelled(mesh, curvature, params::flatness_threshold(not_a_number)); },
                 {"flatness_threshold is nan", "give"});
}
