// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spider/extract_isolines.h>

#include "tracing.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <map>
#include <random>
#include <set>
#include <type_traits>

namespace {

using namespace tracing;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <typename Mesh>
using Scalars = std::map<Vertex_of<Mesh>, double>;

template <typename Mesh, typename Function>
Scalars<Mesh> scalars(const Mesh& mesh, Function&& of_point)
{
  Scalars<Mesh> result;
  for(auto v : vertices(mesh))
    result[v] = of_point(meshes::point(mesh, v));
  return result;
}

template <typename Mesh>
auto isolines(const Mesh& mesh, const Scalars<Mesh>& scalars, double value)
{
  std::vector<Spider::Isoline_3<Mesh>> result;
  Spider::extract_isolines(mesh, boost::const_associative_property_map<Scalars<Mesh>>(scalars), value,
                           std::back_inserter(result));
  return result;
}

// ---- What isolines are, said by sets instead of walks: an oracle for any mesh whose points are all different ----

using Coordinates = std::array<double, 3>;
using Segment = std::pair<Coordinates, Coordinates>;

Coordinates coordinates(const Vector& p) { return {p.x(), p.y(), p.z()}; }

/// returns where the scalar has a value on an edge whose ends are below it, and at least it.
Vector crossing(const Vector& low, double below, const Vector& high, double above, double value)
{
  return above == value ? high : low + (value - below) / (above - below) * (high - low);
}

template <typename Mesh>
bool is_finite(const Mesh& mesh, const Scalars<Mesh>& s, Face_of<Mesh> f)
{
  for(auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
    if(!std::isfinite(s.at(v)))
      return false;
  return true;
}

/// returns the directed segment in which a face meets the outline of what is above, if they do.
template <typename Mesh>
std::vector<Segment> segment_in(const Mesh& mesh, const Scalars<Mesh>& s, double value, Face_of<Mesh> f)
{
  std::vector<Vector> from, to;
  for(auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
  {
    const auto a = source(h, mesh), b = target(h, mesh);
    const Vector p = meshes::point(mesh, a), q = meshes::point(mesh, b);
    if(s.at(a) >= value && s.at(b) < value)
      from.push_back(crossing(q, s.at(b), p, s.at(a), value));
    if(s.at(a) < value && s.at(b) >= value)
      to.push_back(crossing(p, s.at(a), q, s.at(b), value));
  }
  if(from.empty() || from[0] == to[0])
    return {};
  return {{coordinates(from[0]), coordinates(to[0])}};
}

/// returns whether nothing is above on the other side of the edge that a face has in the level set, if it has one.
template <typename Mesh>
bool has_nothing_behind(const Mesh& mesh, const Scalars<Mesh>& s, double value, Face_of<Mesh> f)
{
  for(auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
    if(s.at(source(h, mesh)) == value && s.at(target(h, mesh)) == value)
    {
      const auto across = opposite(h, mesh);
      return CGAL::is_border(across, mesh) || !is_finite(mesh, s, face(across, mesh)) ||
             s.at(target(next(across, mesh), mesh)) < value;
    }
  return false;
}

template <typename Mesh>
std::multiset<Segment> expected_segments(const Mesh& mesh, const Scalars<Mesh>& s, double value)
{
  std::multiset<Segment> result;
  for(auto f : faces(mesh))
    if(is_finite(mesh, s, f) && !has_nothing_behind(mesh, s, value, f))
      for(const Segment& segment : segment_in(mesh, s, value, f))
        result.insert(segment);
  return result;
}

/// returns the points on edges and at vertices where a line may end: on the rim of the faces with finite scalars.
template <typename Mesh>
std::set<Coordinates> possible_ends(const Mesh& mesh, const Scalars<Mesh>& s, double value)
{
  std::set<Coordinates> result;
  for(auto h : halfedges(mesh))
  {
    if(!CGAL::is_border(h, mesh) && is_finite(mesh, s, face(h, mesh)))
      continue;
    const auto a = source(h, mesh), b = target(h, mesh);
    const Vector p = meshes::point(mesh, a), q = meshes::point(mesh, b);
    for(const auto& [v, point] : {std::make_pair(a, p), std::make_pair(b, q)})
      if(s.at(v) == value)
        result.insert(coordinates(point));
    if(s.at(a) < value && s.at(b) > value)
      result.insert(coordinates(crossing(p, s.at(a), q, s.at(b), value)));
    if(s.at(b) < value && s.at(a) > value)
      result.insert(coordinates(crossing(q, s.at(b), p, s.at(a), value)));
  }
  return result;
}

/// expects a line's locations to be its points, and those of each segment to share its face.
template <typename Mesh>
void expect_is_on_mesh(const Spider::Isoline_3<Mesh>& line, const Mesh& mesh)
{
  const Polyline points = polyline(line.points);
  ASSERT_EQ(line.locations.size(), points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const auto& [f, w] = line.locations[i];
    const auto [a, b, c] = corners(mesh, f);
    const double rounding = 1e-14 * (a.norm() + b.norm() + c.norm());
    EXPECT_LE((points[i] - (w[0] * a + w[1] * b + w[2] * c)).norm(), rounding);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-15);
    if(i + 1 == points.size())
    {
      EXPECT_EQ(f, line.locations[i - 1].first);
      continue;
    }
    EXPECT_LE(distance_to_triangle(points[i + 1], a, b, c), rounding) << i << " of " << points.size();
  }
}

/// expects of isolines what holds of all: they consist of the expected segments, each once, and end only at the rim.
template <typename Mesh>
void expect_are_isolines(const std::vector<Spider::Isoline_3<Mesh>>& lines, const Mesh& mesh, const Scalars<Mesh>& s,
                         double value)
{
  std::multiset<Segment> segments;
  const std::set<Coordinates> ends = possible_ends(mesh, s, value);
  for(const auto& line : lines)
  {
    ASSERT_GE(line.points.size(), line.is_closed ? 4u : 2u);
    expect_is_on_mesh(line, mesh);
    const Polyline points = polyline(line.points);
    if(line.is_closed)
      EXPECT_EQ(points.front(), points.back());
    else
      for(const Vector& end : {points.front(), points.back()})
        EXPECT_EQ(ends.count(coordinates(end)), 1u) << end.transpose();
    for(std::size_t i = 1; i < points.size(); ++i)
      segments.insert({coordinates(points[i - 1]), coordinates(points[i])});
  }
  EXPECT_EQ(segments, expected_segments(mesh, s, value));
  for(const Segment& segment : segments)
  {
    EXPECT_NE(segment.first, segment.second);
    EXPECT_EQ(segments.count(segment) + segments.count({segment.second, segment.first}), 1u);
  }
}

template <typename Mesh>
auto checked_isolines(const Mesh& mesh, const Scalars<Mesh>& s, double value)
{
  auto lines = isolines(mesh, s, value);
  expect_are_isolines(lines, mesh, s, value);
  return lines;
}

std::size_t number_of_closed(const std::vector<Spider::Isoline_3<Mesh>>& lines)
{
  return std::count_if(lines.begin(), lines.end(), [](const auto& line) { return line.is_closed; });
}

double x_of(const Vector& p) { return p.x(); }
double z_of(const Vector& p) { return p.z(); }

// ---- On any mesh and kernel ----

template <typename Mesh>
class Extract_isolines : public ::testing::Test
{};
TYPED_TEST_SUITE(Extract_isolines, Mesh_types, );

TYPED_TEST(Extract_isolines, of_a_height_on_a_torus_are_two_closed_curves_with_lengths_of_second_order)
{
  // At an angle of 30 degrees around the tube, which is amid a row of faces each time.
  const double tube = 0.4, height = tube * std::sin(meshes::pi / 6), half_width = tube * std::cos(meshes::pi / 6);
  double last_error = 0;
  for(int n : {6, 18, 54})
  {
    const auto mesh = meshes::torus<TypeParam>(1, tube, 2 * n, n);
    const auto lines = checked_isolines(mesh, scalars(mesh, z_of), height);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_TRUE(lines[0].is_closed && lines[1].is_closed);
    for(const auto& line : lines)
      for(const auto& p : line.points)
        EXPECT_NEAR(p.z(), height, 1e-15);
    const double a = length(polyline(lines[0].points)), b = length(polyline(lines[1].points));
    const double error = std::max(std::abs(std::max(a, b) - 2 * meshes::pi * (1 + half_width)),
                                  std::abs(std::min(a, b) - 2 * meshes::pi * (1 - half_width)));
    if(last_error > 0)
    {
      EXPECT_NEAR(std::log(last_error / error) / std::log(3), 2, 0.1) << n;
    }
    last_error = error;
  }
  EXPECT_LT(last_error, 0.01);
}

TYPED_TEST(Extract_isolines, have_the_higher_side_on_their_left)
{
  const auto mesh = meshes::jittered(meshes::icosphere<TypeParam>(2), 0.02, 1);
  const auto lines = checked_isolines(mesh, scalars(mesh, z_of), 0.3);
  ASSERT_EQ(lines.size(), 1u);
  for(std::size_t i = 1; i < lines[0].points.size(); ++i)
  {
    const Vector a = meshes::vector(lines[0].points[i - 1]), b = meshes::vector(lines[0].points[i]);
    EXPECT_GT(a.cross(b).z(), 0);
  }
}

TYPED_TEST(Extract_isolines, end_at_borders_and_where_scalars_are_not_finite)
{
  const auto mesh = meshes::plane<TypeParam>(3);
  for(double nothing : {not_a_number, infinity, -infinity})
  {
    auto s = scalars(mesh, x_of);
    const auto whole = checked_isolines(mesh, s, 0.25);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_FALSE(whole[0].is_closed);
    EXPECT_EQ(meshes::vector(whole[0].points.front()), Vector(0.25, 3, 0));
    EXPECT_EQ(meshes::vector(whole[0].points.back()), Vector(0.25, -3, 0));

    s[vertex_at(mesh, {0, 0, 0})] = nothing;
    const auto halves = checked_isolines(mesh, s, 0.25);
    ASSERT_EQ(halves.size(), 2u);
    double sum = 0;
    for(const auto& line : halves)
    {
      EXPECT_FALSE(line.is_closed);
      sum += length(polyline(line.points));
    }
    EXPECT_NEAR(sum, 6 - 1.75, 1e-14); // the gap is in the star of the vertex, from y = -0.75 to 1
  }
}

// ---- Values that are hit exactly ----

TEST(Extract_isolines, run_through_vertices_and_along_edges)
{
  const Mesh mesh = meshes::plane<Mesh>(3);
  const auto along = checked_isolines(mesh, scalars(mesh, x_of), 1);
  ASSERT_EQ(along.size(), 1u);
  EXPECT_EQ(along[0].points.size(), 7u);
  EXPECT_NEAR(length(polyline(along[0].points)), 6, 1e-14);
  const auto diagonal = checked_isolines(mesh, scalars(mesh, [](const Vector& p) { return p.x() - p.y(); }), 0);
  ASSERT_EQ(diagonal.size(), 1u);
  EXPECT_EQ(diagonal[0].points.size(), 7u);
  // Through a vertex and the middle of an edge by turns
  const auto across = checked_isolines(mesh, scalars(mesh, [](const Vector& p) { return p.x() + p.y(); }), 0);
  ASSERT_EQ(across.size(), 1u);
  EXPECT_EQ(across[0].points.size(), 13u);
}

TEST(Extract_isolines, are_none_of_a_constant)
{
  for(const Mesh& mesh : {meshes::icosphere<Mesh>(1), meshes::plane<Mesh>(2)})
    for(double value : {0.5, 1., 2.})
      EXPECT_TRUE(checked_isolines(mesh, scalars(mesh, [](const Vector&) { return 1.; }), value).empty());
}

TEST(Extract_isolines, are_none_where_the_value_is_only_touched)
{
  const Mesh mesh = meshes::plane<Mesh>(3), tube = meshes::cylinder<Mesh>(1, 2, 8, 3);
  const auto distance = [](const Vector& p) { return std::max(std::abs(p.x()), std::abs(p.y())); };
  const auto fold = [](const Vector& p) { return std::abs(p.x()); };
  for(int sign : {1, -1})
  {
    const auto with_sign = [=](auto f) { return [=](const Vector& p) { return sign * f(p); }; };
    EXPECT_TRUE(checked_isolines(mesh, scalars(mesh, with_sign(distance)), 0).empty()); // a vertex
    EXPECT_TRUE(checked_isolines(mesh, scalars(mesh, with_sign(fold)), 0).empty());     // a ridge or valley
    EXPECT_TRUE(checked_isolines(mesh, scalars(mesh, with_sign(x_of)), 3).empty());     // a border
    EXPECT_TRUE(checked_isolines(tube, scalars(tube, with_sign(z_of)), 0).empty());     // a border all round
  }
}

TEST(Extract_isolines, go_round_a_flat_part_on_the_side_that_is_lower)
{
  const Mesh mesh = meshes::plane<Mesh>(4);
  const auto mesa = [](const Vector& p) { return -std::max({1., std::abs(p.x()), std::abs(p.y())}); };
  const auto lines = checked_isolines(mesh, scalars(mesh, mesa), -1);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].is_closed);
  EXPECT_EQ(lines[0].points.size(), 9u);
  EXPECT_NEAR(length(polyline(lines[0].points)), 8, 1e-14);
  const auto basin = [&](const Vector& p) { return -mesa(p); };
  EXPECT_TRUE(checked_isolines(mesh, scalars(mesh, basin), 1).empty());
  const auto terrace = [](const Vector& p) { return p.x() < 0 ? p.x() + 1 : p.x() > 1 ? p.x() : 1; };
  const auto edge_of_terrace = checked_isolines(mesh, scalars(mesh, terrace), 1);
  ASSERT_EQ(edge_of_terrace.size(), 1u);
  for(const auto& p : edge_of_terrace[0].points)
    EXPECT_EQ(p.x(), 0);
}

TEST(Extract_isolines, leave_out_the_ridge_between_two_hills)
{
  // Two flat squares and the ridge that joins them, with less all around.
  const Mesh mesh = meshes::plane<Mesh>(5);
  const auto dumb_bell = [](const Vector& p) {
    const bool is_square = std::abs(p.y()) <= 1 && std::abs(p.x()) >= 2 && std::abs(p.x()) <= 4;
    return is_square || (p.y() == 0 && std::abs(p.x()) <= 2) ? 1. : 0.;
  };
  const auto lines = checked_isolines(mesh, scalars(mesh, dumb_bell), 1);
  double sum = 0;
  for(const auto& line : lines)
    sum += length(polyline(line.points));
  EXPECT_EQ(lines.size(), 2u);
  EXPECT_EQ(number_of_closed(lines), 2u);
  EXPECT_NEAR(sum, 16 + 2 * std::sqrt(2.), 1e-14); // each square has a triangle more, where the ridge begins
}

TEST(Extract_isolines, are_sound_where_values_are_hit_by_chance)
{
  std::mt19937 random(7);
  std::vector<Mesh> shapes = {meshes::jittered(meshes::plane<Mesh>(4, 1, meshes::alternating), 0.2, 1),
                              meshes::jittered(meshes::icosphere<Mesh>(2), 0.03, 2),
                              meshes::jittered(meshes::torus<Mesh>(1, 0.4, 12, 7), 0.03, 3),
                              meshes::jittered(meshes::cylinder<Mesh>(1, 2, 9, 6, meshes::backward), 0.03, 4)};
  std::size_t number_of_lines = 0, closed = 0;
  for(const Mesh& mesh : shapes)
    for(unsigned levels : {2, 3, 5, 20})
      for(unsigned missing : {0, 8}) // of 100 vertices
        for(int repeat = 0; repeat < 10; ++repeat)
        {
          Scalars<Mesh> s;
          for(auto v : vertices(mesh))
          {
            s[v] = random() % levels;
            if(random() % 100 < missing)
              s[v] = random() % 2 ? not_a_number : infinity;
          }
          for(double value : {0., 1., 1.5, levels - 1.})
          {
            const auto lines = checked_isolines(mesh, s, value);
            number_of_lines += lines.size();
            closed += number_of_closed(lines);
          }
          if(HasFailure())
            return;
        }
  EXPECT_GT(closed, 1000u);
  EXPECT_GT(number_of_lines - closed, 1000u);
}

// ---- Promises ----

TEST(Extract_isolines, of_the_squared_distance_on_noisy_meshes_are_all_closed)
{
  const Mesh mesh = meshes::jittered(meshes::icosphere<Mesh>(4), 0.03, 5); // half an edge length
  const auto s = scalars(mesh, [](const Vector& p) { return p.squaredNorm(); });
  for(double value : {0.98, 1., 1.02})
  {
    const auto lines = checked_isolines(mesh, s, value);
    EXPECT_GT(lines.size(), 50u);
    EXPECT_EQ(number_of_closed(lines), lines.size());
  }
}

TEST(Extract_isolines, of_the_squared_distance_have_lengths_that_converge)
{
  double last_error = 0;
  for(int n : {8, 16, 32})
  {
    const Mesh mesh = meshes::height_field<Mesh>(n, 1.2 / n, [](double x, double y) { return x * y / 2; });
    const auto s = scalars(mesh, [](const Vector& p) { return p.x() * p.x() + p.y() * p.y(); });
    const auto lines = checked_isolines(mesh, s, 1);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].is_closed);
    double exact = 0; // of (cos t, sin t, sin 2t / 4)
    const int steps = 1000;
    for(int i = 0; i < steps; ++i)
      exact += 2 * meshes::pi / steps * std::sqrt(1 + std::pow(std::cos(4 * meshes::pi * i / steps) / 2, 2));
    const double error = std::abs(length(polyline(lines[0].points)) - exact);
    if(last_error > 0)
    {
      EXPECT_GT(std::log2(last_error / error), 1.7) << n;
    }
    last_error = error;
  }
  EXPECT_LT(last_error, 3e-3);
}

TEST(Extract_isolines, run_the_other_way_over_the_same_points_when_the_mesh_is_turned_inside_out)
{
  const Mesh mesh = meshes::jittered(meshes::torus<Mesh>(1, 0.4, 20, 12), 0.03, 6);
  const auto s = scalars(mesh, z_of);
  Mesh flipped = mesh;
  CGAL::Polygon_mesh_processing::reverse_face_orientations(flipped);
  std::set<Segment> there;
  for(const auto& line : checked_isolines(flipped, s, 0.1))
    for(std::size_t i = 1; i < line.points.size(); ++i)
      there.insert({coordinates(meshes::vector(line.points[i])), coordinates(meshes::vector(line.points[i - 1]))});
  const auto here = expected_segments(mesh, s, 0.1);
  EXPECT_EQ(there, std::set<Segment>(here.begin(), here.end()));
}

TEST(Extract_isolines, are_of_numbers_of_any_type)
{
  const Mesh mesh = meshes::icosphere<Mesh>(1);
  const auto expect_line = [&](auto number, auto value) {
    using Number = decltype(number);
    const auto map = boost::make_function_property_map<Vertex_of<Mesh>>(
      [&](Vertex_of<Mesh> v) { return Number(std::lround(10 * mesh.point(v).z())); });
    std::vector<Spider::Isoline_3<Mesh>> lines;
    Spider::extract_isolines(mesh, map, value, std::back_inserter(lines));
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].is_closed);
  };
  expect_line(int(), 1);
  expect_line(float(), 1.5);
  expect_line(char(), 1u);
  expect_line(CGAL::Exact_predicates_exact_constructions_kernel::FT(), CGAL::Gmpq(3, 2));
}

TEST(Extract_isolines, bear_scalars_of_any_size)
{
  const Mesh mesh = meshes::plane<Mesh>(2);
  for(double size : {1e-320, 1e-300, 1., 1e300, 8e307})
  {
    const auto lines = isolines(mesh, scalars(mesh, [&](const Vector& p) { return size * p.x(); }), size / 2);
    ASSERT_EQ(lines.size(), 1u);
    for(const auto& p : lines[0].points)
      EXPECT_NEAR(p.x(), 0.5, size > 1e-310 ? 1e-15 : 1e-3);
  }
  // The difference of these scalars isn't finite.
  const auto steep = scalars(mesh, [](const Vector& p) { return p.x() > 0 ? 1.7e308 : -1.7e308; });
  const auto lines = isolines(mesh, steep, 0);
  ASSERT_EQ(lines.size(), 1u);
  for(const auto& p : lines[0].points)
    EXPECT_NEAR(p.x(), 0.5, 1e-15);
}

TEST(Extract_isolines, have_no_segment_that_rounding_makes_a_point)
{
  // Far from the origin, all crossings around a summit are at the same point.
  const Mesh mesh =
    meshes::moved(meshes::plane<Mesh>(2), [](const Vector& p) { return Vector(p + Vector(1e8, 1e8, 1e8)); });
  const auto s = scalars(mesh, [](const Vector& p) { return -(p - Vector(1e8, 1e8, 1e8)).norm(); });
  EXPECT_TRUE(isolines(mesh, s, -1e-9).empty());
  EXPECT_EQ(isolines(mesh, s, -1e-2).size(), 1u);
}

TEST(Extract_isolines, take_named_parameters)
{
  const Mesh mesh = meshes::plane<Mesh>(1);
  std::map<Vertex_of<Mesh>, CGAL::Simple_cartesian<float>::Point_3> points;
  for(auto v : vertices(mesh))
    points[v] = {7, float(mesh.point(v).x()), float(mesh.point(v).y())};
  const auto s = scalars(mesh, x_of);
  std::vector<Spider::Isoline_3<Mesh, CGAL::Simple_cartesian<float>>> lines;
  Spider::extract_isolines(mesh, boost::const_associative_property_map<Scalars<Mesh>>(s), 0.5,
                           std::back_inserter(lines),
                           CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(points))
                             .geom_traits(CGAL::Simple_cartesian<float>()));
  ASSERT_EQ(lines.size(), 1u);
  for(const auto& p : lines[0].points)
  {
    EXPECT_EQ(p.x(), 7);
    EXPECT_EQ(p.y(), 0.5);
  }
}

TEST(Extract_isolines, refuses_what_it_cannot_work_with)
{
  const Mesh mesh = meshes::icosphere<Mesh>(0);
  const auto s = scalars(mesh, z_of);
  expect_refused([&] { isolines(mesh, s, not_a_number); }, {"value is nan", "finite"});
  expect_refused([&] { isolines(mesh, s, infinity); }, {"value is inf", "finite"});
  Mesh cube;
  CGAL::make_hexahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                        Kernel::Point_3(0, 1, 0), Kernel::Point_3(0, 1, 1), Kernel::Point_3(0, 0, 1),
                        Kernel::Point_3(1, 0, 1), Kernel::Point_3(1, 1, 1), cube);
  expect_refused([&] { isolines(cube, scalars(cube, z_of), 0.5); }, {"not a triangle", "triangulate_faces()"});
}

} // namespace
