// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spider/trace_limb.h>

#include "tracing.h"

#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/boost/graph/generators.h>

namespace {

using namespace tracing;
using Spider::trace_limb;
using Spider::parameters::geodesic_radius;

template <typename Mesh>
class Trace_limb : public ::testing::Test
{};
TYPED_TEST_SUITE(Trace_limb, Mesh_types, );

/// returns the unit vectors at regular angles around the z axis.
std::vector<Vector> directions_around_z(int count)
{
  std::vector<Vector> result;
  for(int i = 0; i < count; ++i)
    result.emplace_back(std::cos(2 * meshes::pi * i / count), std::sin(2 * meshes::pi * i / count), 0);
  return result;
}

TYPED_TEST(Trace_limb, lies_on_the_mesh_and_in_the_half_plane_and_is_as_long_as_asked_for)
{
  const auto mesh = meshes::jittered(meshes::icosphere<TypeParam>(2), 0.03, 1);
  int number = 0;
  for(auto v : vertices(mesh))
  {
    if(number++ % 20 != 0)
      continue;
    const Vector p = meshes::point(mesh, v), n = vertex_normal(mesh, v);
    for(const Vector& d : {Vector(1, 0.2, 0.1), Vector(-0.3, 1, 0.7), Vector(0.1, -0.4, -1)})
      for(double radius : {1e-6, 0.1, 1., 3.})
      {
        const auto limb = trace_limb(v, kernel_vector(n), kernel_vector(d), mesh, geodesic_radius(radius));
        EXPECT_EQ(limb.end, Spider::radius_reached);
        expect_is_limb(limb, mesh, p, n, d, radius);
      }
  }
}

TYPED_TEST(Trace_limb, starts_at_any_point_of_a_face)
{
  const auto mesh = meshes::jittered(meshes::saddle<TypeParam>(4, 0.25), 0.05, 2);
  for(const std::array<double, 3>& w :
      {std::array<double, 3>{0.2, 0.3, 0.5}, {0.98, 0.01, 0.01}, {0.5, 0, 0.5}, {0, 1, 0}})
  {
    const auto query = location<TypeParam>(*std::next(faces(mesh).begin(), 70), w[0], w[1], w[2]);
    const Vector n(0.1, 0.1, 1), p = point_of(mesh, query);
    for(const Vector& d : directions_around_z(7))
    {
      const auto limb = trace_limb(query, kernel_vector(n), kernel_vector(d), mesh, geodesic_radius(0.6));
      EXPECT_EQ(limb.end, Spider::radius_reached);
      expect_is_limb(limb, mesh, p, n, d, 0.6);
    }
  }
}

TYPED_TEST(Trace_limb, takes_only_the_part_of_the_direction_that_is_orthogonal_to_the_normal)
{
  const auto mesh = meshes::icosphere<TypeParam>(2);
  const auto v = *vertices(mesh).begin();
  const Vector n = vertex_normal(mesh, v), d(0.3, 0.2, 0.9), flat = d - d.dot(n) * n;
  const auto expected = trace_limb(v, kernel_vector(n), kernel_vector(flat), mesh, geodesic_radius(0.8));
  for(const Vector& same : {d, Vector(flat + 5 * n), Vector(1e-200 * d), Vector(1e200 * d)})
  {
    const auto limb = trace_limb(v, kernel_vector(7 * n), kernel_vector(same), mesh, geodesic_radius(0.8));
    EXPECT_LE(distance(polyline(limb.polyline), polyline(expected.polyline)), 1e-14);
  }
}

TYPED_TEST(Trace_limb, is_the_same_from_a_vertex_and_from_that_corner_of_each_face)
{
  const auto mesh = meshes::jittered(meshes::torus<TypeParam>(1, 0.4, 12, 8), 0.02, 3);
  const auto v = *std::next(vertices(mesh).begin(), 40);
  const auto n = kernel_vector(vertex_normal(mesh, v)), d = kernel_vector({0.2, 0.5, 0.8});
  const auto expected = trace_limb(v, n, d, mesh, geodesic_radius(0.9));
  for(auto f : CGAL::faces_around_target(halfedge(v, mesh), mesh))
  {
    const auto h = halfedge(f, mesh);
    const auto query =
      location<TypeParam>(f, source(h, mesh) == v, target(h, mesh) == v, target(next(h, mesh), mesh) == v);
    EXPECT_EQ(trace_limb(query, n, d, mesh, geodesic_radius(0.9)).polyline, expected.polyline);
  }
}

TYPED_TEST(Trace_limb, is_the_same_from_both_faces_of_an_edge)
{
  const auto mesh = meshes::jittered(meshes::torus<TypeParam>(1, 0.4, 12, 8), 0.02, 3);
  const auto at = [&](auto h, double weight_of_source) {
    const auto f = face(h, mesh);
    auto query = location<TypeParam>(f, 0, 0, 0);
    auto corner = halfedge(f, mesh);
    for(int i = 0; i < 3; ++i, corner = next(corner, mesh))
      query.second[i] = source(corner, mesh) == source(h, mesh)   ? weight_of_source
                        : source(corner, mesh) == target(h, mesh) ? 1 - weight_of_source
                                                                  : 0.;
    return query;
  };
  int number = 0;
  for(auto e : edges(mesh))
  {
    if(number++ % 30 != 0)
      continue;
    const auto h = halfedge(e, mesh);
    const auto n = kernel_vector(face_normal(mesh, face(h, mesh)) + face_normal(mesh, face(opposite(h, mesh), mesh)));
    for(const Vector& d : {Vector(1, 0.2, 0.3), Vector(-1, 0.3, 0.5), Vector(0.1, 0.3, -1)})
    {
      // a power of two, so that both sides' weights are exactly those of one point
      const auto one = trace_limb(at(h, 0.25), n, kernel_vector(d), mesh, geodesic_radius(0.9));
      const auto other = trace_limb(at(opposite(h, mesh), 0.75), n, kernel_vector(d), mesh, geodesic_radius(0.9));
      EXPECT_EQ(one.polyline, other.polyline);
      EXPECT_GT(one.polyline.size(), 2u);
    }
  }
}

TEST(Trace_limb, changes_little_where_its_query_crosses_an_edge_or_a_vertex)
{
  const Mesh mesh = meshes::jittered(meshes::saddle<Mesh>(4, 0.25), 0.03, 4);
  const auto f = *std::next(faces(mesh).begin(), 70);
  const Kernel::Vector_3 n(0.1, 0.2, 1);
  for(const Vector& d : directions_around_z(16))
  {
    const auto end = [&](double a, double b, double c) {
      const auto limb = trace_limb(location<Mesh>(f, a, b, c), n, kernel_vector(d), mesh, geodesic_radius(0.7));
      return meshes::vector(limb.polyline.back());
    };
    constexpr double move = 1e-9, most = 1e-6; // a crossing near parallel to an edge magnifies the move
    EXPECT_LE((end(0.3, 0.7, 0) - end(0.3, 0.7 - move, move)).norm(), most);
    EXPECT_LE((end(0, 0.4, 0.6) - end(move, 0.4, 0.6 - move)).norm(), most);
    EXPECT_LE((end(1, 0, 0) - end(1 - move, move, 0)).norm(), most);
    EXPECT_LE((end(1, 0, 0) - end(1 - 2 * move, move, move)).norm(), most);
  }
}

TEST(Trace_limb, is_straight_on_a_plane)
{
  const Mesh mesh = meshes::jittered(meshes::plane<Mesh>(8), 0.3, 5);
  const Mesh flat = meshes::moved(mesh, [](const Vector& p) { return Vector(p.x(), p.y(), 0); });
  const auto v = vertex_at(flat, {0, 0, 0});
  for(const Vector& d : directions_around_z(24))
  {
    const auto limb = trace_limb(v, Kernel::Vector_3(0, 0, 1), kernel_vector(d), flat, geodesic_radius(5.5));
    EXPECT_LE((meshes::vector(limb.polyline.back()) - meshes::point(flat, v) - 5.5 * d).norm(), 1e-13);
  }
}

TEST(Trace_limb, ends_at_a_border_and_tells_which_edge)
{
  const Mesh mesh = meshes::plane<Mesh>(3);
  const auto v = vertex_at(mesh, {0, 0, 0});
  for(const Vector& d : {Vector(1, 0.3, 0), Vector(-0.2, 1, 0), Vector(-1, -0.1, 0), Vector(0.4, -1, 0)})
  {
    const auto limb = trace_limb(v, Kernel::Vector_3(0, 0, 1), kernel_vector(d), mesh, geodesic_radius(10));
    ASSERT_EQ(limb.end, Spider::border);
    const Vector end = meshes::vector(limb.polyline.back());
    EXPECT_LE((end - 3 * d / d.lpNorm<Eigen::Infinity>()).norm(), 1e-13);
    EXPECT_NEAR(limb.length, end.norm(), 1e-13);
    EXPECT_TRUE(CGAL::is_border(limb.edge, mesh));
    const auto h = halfedge(limb.edge, mesh);
    EXPECT_LE(distance_to_segment(end, meshes::point(mesh, source(h, mesh)), meshes::point(mesh, target(h, mesh))),
              1e-13);
  }
}

TEST(Trace_limb, crosses_an_edge_whose_ends_are_farther_apart_than_any_number)
{
  const Mesh mesh = meshes::from_soup<Mesh>({{0, 0, 0}, {1.2e308, 1e300, 0}, {-1.2e308, 1e300, 0}}, {{0, 1, 2}});
  const auto limb =
    trace_limb(Vertex_of<Mesh>(0), Kernel::Vector_3(0, 0, 1), Kernel::Vector_3(0, 1, 0), mesh, geodesic_radius(2e300));
  EXPECT_EQ(limb.end, Spider::border);
  ASSERT_EQ(limb.polyline.size(), 2u);
  EXPECT_NEAR(limb.polyline[1].y() / 1e300, 1, 1e-12);
  EXPECT_NEAR(limb.length / 1e300, 1, 1e-12);
}

TEST(Trace_limb, ends_where_the_section_closes_before_the_radius_is_reached)
{
  const Mesh mesh = meshes::icosphere<Mesh>(2);
  const auto v = *vertices(mesh).begin();
  const Vector n = vertex_normal(mesh, v), d(0.3, 0.2, 0.9);
  const auto limb = trace_limb(v, kernel_vector(n), kernel_vector(d), mesh, geodesic_radius(1e6));
  EXPECT_EQ(limb.end, Spider::degenerate);
  EXPECT_EQ(limb.edge, boost::graph_traits<Mesh>::edge_descriptor());
  EXPECT_LE((meshes::vector(limb.polyline.back()) - meshes::vector(limb.polyline.front())).norm(), 1e-9);
  EXPECT_NEAR(limb.length, 2 * meshes::pi, 0.1);                   // a great circle's
  EXPECT_NEAR(limb.length, length(polyline(limb.polyline)), 1e-9); // rounding of the radius
}

TEST(Trace_limb, is_one_point_at_an_isolated_vertex)
{
  Mesh mesh = meshes::plane<Mesh>(1);
  const auto v = mesh.add_vertex(Kernel::Point_3(1, 2, 3));
  const auto limb = trace_limb(v, Kernel::Vector_3(0, 0, 1), Kernel::Vector_3(1, 0, 0), mesh);
  EXPECT_EQ(limb.polyline, std::vector<Kernel::Point_3>{mesh.point(v)});
  EXPECT_EQ(limb.length, 0);
  EXPECT_EQ(limb.end, Spider::degenerate);
}

TEST(Trace_limb, is_one_point_where_the_half_plane_leaves_the_mesh_at_once)
{
  const Mesh mesh = meshes::plane<Mesh>(1);
  const auto limb = trace_limb(vertex_at(mesh, {1, 0, 0}), Kernel::Vector_3(0, 0, 1), Kernel::Vector_3(1, 0.2, 0), mesh,
                               geodesic_radius(1));
  EXPECT_EQ(limb.polyline, std::vector<Kernel::Point_3>{Kernel::Point_3(1, 0, 0)});
  EXPECT_EQ(limb.length, 0);
  EXPECT_EQ(limb.end, Spider::border);
}

TEST(Trace_limb, reaches_four_mean_edges_or_what_a_property_map_says)
{
  Mesh mesh = meshes::icosphere<Mesh>(3);
  const auto v = *vertices(mesh).begin();
  const Kernel::Vector_3 n = kernel_vector(vertex_normal(mesh, v)), d(0.3, 0.2, 0.9);
  EXPECT_NEAR(trace_limb(v, n, d, mesh).length, 4 * meshes::mean_edge_length(mesh), 1e-14);

  auto radii = mesh.add_property_map<Mesh::Vertex_index, double>("v:radius").first;
  for(auto u : mesh.vertices())
    radii[u] = 0.1 * (1 + mesh.point(u).z());
  radii[v] = 0.25;
  EXPECT_NEAR(trace_limb(v, n, d, mesh, geodesic_radius(radii)).length, 0.25, 1e-15);

  const auto query = location<Mesh>(*faces(mesh).begin(), 0.2, 0.3, 0.5);
  const auto h = halfedge(query.first, mesh);
  const double interpolated =
    0.2 * radii[source(h, mesh)] + 0.3 * radii[target(h, mesh)] + 0.5 * radii[target(next(h, mesh), mesh)];
  EXPECT_NEAR(trace_limb(query, n, d, mesh, geodesic_radius(radii)).length, interpolated, 1e-15);
}

TEST(Trace_limb, takes_points_from_the_map_and_results_to_the_kernel_it_is_given)
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  Mesh mesh = meshes::plane<Mesh>(3);
  auto points = mesh.add_property_map<Mesh::Vertex_index, Epick::Point_3>("v:other").first;
  for(auto v : mesh.vertices())
    points[v] = Epick::Point_3(mesh.point(v).x() + 10, mesh.point(v).y(), 0);
  const auto limb = trace_limb(vertex_at(mesh, {0, 0, 0}), Epick::Vector_3(0, 0, 1), Kernel::Vector_3(1, 0.1, 0), mesh,
                               geodesic_radius(2).vertex_point_map(points).geom_traits(Epick()));
  EXPECT_EQ(limb.polyline.front(), Epick::Point_3(10, 0, 0));
  EXPECT_NEAR(limb.length, 2, 1e-15);
}

/// A limb's plane cut by CGAL: all polylines of the mesh in it.
class Slicer
{
public:
  using Slicer_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Slicer_mesh = CGAL::Surface_mesh<Slicer_kernel::Point_3>;

  explicit Slicer(const Slicer_mesh& mesh) : slicer_(mesh) {}

  std::vector<Polyline> operator()(const Vector& p, const Vector& across) const
  {
    std::vector<std::vector<Slicer_kernel::Point_3>> sections;
    slicer_(Slicer_kernel::Plane_3(Slicer_kernel::Point_3(p.x(), p.y(), p.z()),
                                   Slicer_kernel::Vector_3(across.x(), across.y(), across.z())),
            std::back_inserter(sections));
    std::vector<Polyline> result;
    for(const auto& section : sections)
      result.push_back(polyline(section));
    return result;
  }

private:
  CGAL::Polygon_mesh_slicer<Slicer_mesh, Slicer_kernel> slicer_;
};

/// returns the part of a polyline, closed if its ends are the same, from its segment `first` on, in its order or
/// against it: it starts at `p`, and is shortened to `most` in length.
Polyline part_of(const Polyline& section, std::size_t first, bool forward, const Vector& p, double most)
{
  const std::size_t count = section.size() - 1; // of segments
  const bool is_closed = section.front() == section.back();
  Polyline part = {p};
  double walked = 0;
  for(std::size_t i = 0; i <= count; ++i)
  {
    if(!is_closed && (forward ? first + i >= count : i > first))
      break;
    const Vector to = forward ? section[(first + i) % count + 1] : section[(first + count - i) % count];
    const double step = (to - part.back()).norm();
    if(walked + step >= most)
    {
      const Vector end = part.back() + (most - walked) / step * (to - part.back());
      part.push_back(end);
      break;
    }
    part.push_back(to);
    walked += step;
  }
  return part;
}

/// returns how far a piece of a limb is from the part of a section that starts where it starts and is as long.
double distance_to_sections(const Polyline& piece, const std::vector<Polyline>& sections, double rounding)
{
  const double most = length(piece);
  double least = std::numeric_limits<double>::infinity();
  for(const Polyline& section : sections)
    for(std::size_t i = 0; i + 1 < section.size(); ++i)
      if(distance_to_segment(piece.front(), section[i], section[i + 1]) <= rounding)
        for(bool forward : {true, false})
        {
          const Polyline part = part_of(section, i, forward, piece.front(), most);
          least = std::min(least, std::max(distance(part, piece), (part.back() - piece.back()).norm()));
        }
  return least;
}

/// cuts a limb where it comes back to its start. There the section crosses itself, which it does where a star is
/// folded, and the slicer may go on by another of the ways from there.
std::vector<Polyline> pieces_of(const Polyline& limb, double rounding)
{
  std::vector<Polyline> pieces(1);
  for(const Vector& q : limb)
  {
    pieces.back().push_back(q);
    if((q - limb.front()).norm() > rounding)
      continue;
    if(pieces.back().size() > 2)
      pieces.emplace_back();
    pieces.back() = {limb.front()};
  }
  if(pieces.back().size() < 2)
    pieces.pop_back();
  return pieces;
}

/// tells whether the half plane cuts a face around a vertex ahead of it. Where the star is folded it may cut none.
template <typename Mesh>
bool meets_star(const Mesh& mesh, Vertex_of<Mesh> v, const Vector& direction, const Vector& across)
{
  const Vector p = meshes::point(mesh, v);
  for(auto f : CGAL::faces_around_target(halfedge(v, mesh), mesh))
  {
    if(f == boost::graph_traits<Mesh>::null_face())
      continue;
    auto h = halfedge(f, mesh);
    while(target(next(h, mesh), mesh) != v)
      h = next(h, mesh);
    const Vector s = meshes::point(mesh, source(h, mesh)) - p, t = meshes::point(mesh, target(h, mesh)) - p;
    const double a = s.dot(across), b = t.dot(across);
    if(a * b < 0 && (s + a / (a - b) * (t - s)).dot(direction) > 0)
      return true;
  }
  return false;
}

/// compares the limbs at every `stride`-th vertex with the slicer's cuts.
void compare_with_slicer(const Slicer::Slicer_mesh& mesh, int stride, double radius_in_edges)
{
  const Slicer slicer(mesh);
  const double radius = radius_in_edges * meshes::mean_edge_length(mesh), most = 1e-9 * radius;
  const auto count = vertices(mesh).size();
  std::size_t compared = 0;
  for(std::size_t i = 0; i < count; i += stride)
  {
    const auto v = *std::next(vertices(mesh).begin(), i);
    const Vector n = mesh.is_isolated(v) ? Vector(Vector::Zero()) : vertex_normal(mesh, v);
    if(!n.allFinite() || n.isZero())
      continue;
    SCOPED_TRACE("at vertex " + std::to_string(i));
    const Vector p = meshes::point(mesh, v);
    const Vector d = n.cross(Vector(std::sin(1. * i), std::cos(1. * i), std::sin(2. * i))).normalized();
    const auto limb = trace_limb(v, kernel_vector(n), kernel_vector(d), mesh, geodesic_radius(radius));
    EXPECT_EQ(limb.polyline.size() > 1, meets_star(mesh, v, d, n.cross(d)));
    if(limb.polyline.size() == 1)
      continue;
    const auto sections = slicer(p, n.cross(d));
    for(const Polyline& piece : pieces_of(polyline(limb.polyline), most))
      EXPECT_LE(distance_to_sections(piece, sections, most), most);
    EXPECT_NEAR(length(polyline(limb.polyline)), limb.length, most);
    EXPECT_GE((meshes::vector(limb.polyline[1]) - p).dot(d), -1e-13 * radius);
    ++compared;
  }
  EXPECT_GE(compared, count / stride * 0.7); // the others are on borders, or on folded stars
}

TEST(Trace_limb, agrees_with_a_slicer_on_noisy_analytic_meshes)
{
  using Slicer_mesh = Slicer::Slicer_mesh;
  const auto noisy = [](Slicer_mesh mesh, double share, unsigned seed) {
    const double amplitude = share * meshes::mean_edge_length(mesh);
    return meshes::jittered(std::move(mesh), amplitude, seed);
  };
  compare_with_slicer(noisy(meshes::icosphere<Slicer_mesh>(3), 0.3, 1), 1, 6);
  compare_with_slicer(noisy(meshes::torus<Slicer_mesh>(1, 0.4, 50, 9), 0.3, 2), 1, 8);
  compare_with_slicer(noisy(meshes::saddle<Slicer_mesh>(12, 0.1), 0.5, 3), 1, 5);
  compare_with_slicer(noisy(meshes::cylinder<Slicer_mesh>(1, 3, 12, 40), 0.2, 4), 1, 5);
  compare_with_slicer(noisy(meshes::cube<Slicer_mesh>(8, meshes::alternating), 0.1, 5), 1, 20);
}

class Trace_limb_slicer : public ::testing::TestWithParam<const char*>
{};

TEST_P(Trace_limb_slicer, agrees_with_a_slicer_on_scans_and_models)
{
  Slicer::Slicer_mesh mesh;
  if(!meshes::read(GetParam(), mesh))
    GTEST_SKIP() << "no " << GetParam() << " in " << SPIDER_DATA_DIR << " (Debian and Ubuntu: libcgal-demo)";
  const std::size_t most = 1000; // vertices, which takes about a second
  compare_with_slicer(mesh, 1 + int(vertices(mesh).size() / most), 4);
}

INSTANTIATE_TEST_SUITE_P(, Trace_limb_slicer,
                         ::testing::Values("bunny00.off", "elephant.off", "anchor.off", "fandisk.off", "camel.off",
                                           "mannequin-devil.off", "mesh_with_border.off", "nefertiti.off",
                                           "elephant-with-holes.off"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace_if(
                             name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

TEST(Trace_limb, scales_with_the_mesh_to_the_last_bit)
{
  const Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(2), 0.03, 6);
  const auto v = *vertices(mesh).begin();
  const Kernel::Vector_3 n = kernel_vector(vertex_normal(mesh, v)), d(0.3, 0.2, 0.9);
  const auto expected = trace_limb(v, n, d, mesh, geodesic_radius(2.));
  ASSERT_GT(expected.polyline.size(), 10u);
  for(int exponent : {-300, -40, 1, 40, 300})
  {
    const double scale = std::ldexp(1., exponent);
    const Mesh scaled = meshes::moved(mesh, [&](const Vector& p) { return Vector(scale * p); });
    const auto limb = trace_limb(v, n, d, scaled, geodesic_radius(2 * scale));
    EXPECT_EQ(limb.length, scale * expected.length);
    ASSERT_EQ(limb.polyline.size(), expected.polyline.size());
    for(std::size_t i = 0; i < limb.polyline.size(); ++i)
      EXPECT_EQ(meshes::vector(limb.polyline[i]), scale * meshes::vector(expected.polyline[i]));
  }
}

TEST(Trace_limb, moves_with_the_mesh)
{
  const Mesh mesh = meshes::jittered(meshes::torus<Mesh>(1, 0.4, 30, 16), 0.02, 7);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vector(1, 2, 3).normalized()).toRotationMatrix();
  for(const auto& [shift, rounding] : {std::pair<Vector, double>{{1, -2, 0.5}, 1e-13}, {{1e8, -3e8, 2e8}, 1e-5}})
  {
    const auto move = [&, by = shift](const Vector& p) { return Vector(turn * p + by); };
    const Mesh there = meshes::moved(mesh, move);
    for(int i = 0; i < 480; i += 37)
    {
      const auto v = *std::next(vertices(mesh).begin(), i);
      const Vector n = vertex_normal(mesh, v), d(0.3, 0.2, 0.9);
      const auto limb = trace_limb(v, kernel_vector(n), kernel_vector(d), mesh, geodesic_radius(1.));
      const auto moved = trace_limb(v, kernel_vector(turn * n), kernel_vector(turn * d), there, geodesic_radius(1.));
      Polyline expected;
      for(const auto& q : limb.polyline)
        expected.push_back(move(meshes::vector(q)));
      EXPECT_EQ(moved.end, limb.end);
      EXPECT_LE(distance(polyline(moved.polyline), expected), rounding);
      EXPECT_LE((meshes::vector(moved.polyline.back()) - expected.back()).norm(), rounding);
    }
  }
}

TEST(Trace_limb, refuses_what_it_cannot_work_with)
{
  const Mesh mesh = meshes::icosphere<Mesh>(1);
  const auto v = *vertices(mesh).begin();
  const auto f = *faces(mesh).begin();
  const Kernel::Vector_3 n(0, 0, 1), d(1, 0, 0), none(0, 0, 0);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

  expect_refused([&] { trace_limb(v, none, d, mesh); }, {"normal is 0 0 0", "not zero"});
  expect_refused([&] { trace_limb(v, Kernel::Vector_3(0, nan, 1), d, mesh); }, {"normal is", "nan"});
  expect_refused([&] { trace_limb(v, Kernel::Vector_3(0, infinity, 1), d, mesh); }, {"normal is", "inf"});
  expect_refused([&] { trace_limb(v, n, none, mesh); }, {"direction is 0 0 0", "parallel"});
  expect_refused([&] { trace_limb(v, n, Kernel::Vector_3(0, 0, -4), mesh); }, {"direction is", "-4", "parallel"});
  expect_refused([&] { trace_limb(v, n, Kernel::Vector_3(nan, 0, 0), mesh); }, {"direction is", "nan"});
  expect_refused([&] { trace_limb(v, n, d, mesh, geodesic_radius(0)); }, {"geodesic_radius is 0", "positive"});
  expect_refused([&] { trace_limb(v, n, d, mesh, geodesic_radius(-2.5)); }, {"geodesic_radius is -2.5", "positive"});
  expect_refused([&] { trace_limb(v, n, d, mesh, geodesic_radius(nan)); }, {"geodesic_radius is", "nan"});
  expect_refused([&] { trace_limb(v, n, d, mesh, geodesic_radius(infinity)); }, {"geodesic_radius is inf"});
  expect_refused([&] { trace_limb(Mesh::null_vertex(), n, d, mesh); }, {"query is the null vertex", "give"});
  expect_refused([&] { trace_limb(location<Mesh>(Mesh::null_face(), 1, 0, 0), n, d, mesh); },
                 {"query is at the null face"});
  expect_refused([&] { trace_limb(location<Mesh>(f, 0.5, 0.5, 0.5), n, d, mesh); },
                 {"query", "(0.5, 0.5, 0.5)", "sum to 1"});
  expect_refused([&] { trace_limb(location<Mesh>(f, 1.5, -0.5, 0), n, d, mesh); },
                 {"query", "(1.5, -0.5, 0)", "negative"});
  expect_refused([&] { trace_limb(location<Mesh>(f, nan, 0.5, 0.5), n, d, mesh); }, {"query", "nan"});
}

TEST(Trace_limb, refuses_a_radius_of_a_property_map_that_is_none)
{
  Mesh mesh = meshes::icosphere<Mesh>(1);
  const auto v = *vertices(mesh).begin();
  for(double bad : {0., -2.5, std::numeric_limits<double>::quiet_NaN()})
  {
    auto radii = mesh.add_property_map<Mesh::Vertex_index, double>("v:radius", bad).first;
    expect_refused(
      [&] { trace_limb(v, Kernel::Vector_3(0, 0, 1), Kernel::Vector_3(1, 0, 0), mesh, geodesic_radius(radii)); },
      {"geodesic_radius is"});
    mesh.remove_property_map(radii);
  }
}

TEST(Trace_limb, refuses_faces_that_are_not_triangles)
{
  Mesh quads;
  CGAL::make_quad(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                  Kernel::Point_3(0, 1, 0), quads);
  const Kernel::Vector_3 n(0, 0, 1), d(1, 0.5, 0);
  expect_refused([&] { trace_limb(*vertices(quads).begin(), n, d, quads, geodesic_radius(1)); },
                 {"tmesh has a face that is not a triangle", "triangulate_faces"});
  expect_refused(
    [&] { trace_limb(location<Mesh>(*faces(quads).begin(), 0.2, 0.3, 0.5), n, d, quads, geodesic_radius(1)); },
    {"tmesh has a face that is not a triangle", "triangulate_faces"});
}

} // namespace
