// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: limbs that are walked in lockstep go where each would go alone, and their moments are the normal
// equations of all their samples. The walk of one limb, and sums over full rows of terms, are the oracles.

#include "estimation.h"

#include <CGAL/Spider/internal/Expected_terms.h>
#include <CGAL/Spider/internal/Limb_bundle.h>
#include <CGAL/Spider/internal/Limb_moments.h>
#include <CGAL/Spider/internal/spatial_order.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

using namespace estimation;
namespace internal = Spider::internal;

namespace {

constexpr double radius = 0.6;
constexpr double rounding = 1e-9; // in units of the radius; lanes may contract multiplications and additions otherwise

using Point_map = Mesh::Property_map<Vertex, Kernel::Point_3>;
using View = internal::Graph_view<Mesh, Point_map>;
using Snapshot = internal::Mesh_snapshot<double>;
using Values = internal::Lanes<double>;

template <typename AnyView>
Snapshot snapshot_of(const Mesh& mesh, const AnyView& view)
{
  return Snapshot(mesh, view, internal::Ranks<Vertex>(vertices(mesh)), internal::Ranks<Mesh::Face_index>(faces(mesh)));
}

constexpr int most_limbs = 8; // more than one bundle on machines with narrow registers

/// walks a bundle of limbs both ways, and compares where they end.
template <typename AnyView>
void expect_same_walks(const AnyView& view, const internal::Site<AnyView>& site, const internal::Star<AnyView>& star,
                       const Values& cosines, const Values& sines, Spider::Limb_measure measure, int number_of_limbs)
{
  internal::Limb_bundle<AnyView> limbs(view, site, star, cosines, sines, number_of_limbs, measure);
  Values gained(0);
  limbs.walk([&](const internal::Segments<double>& next) { gained += next.gain; });

  for(int l = 0; l < number_of_limbs; ++l)
  {
    SCOPED_TRACE(l);
    double y = 0;
    internal::Limb_rule<double> rule = measure;
    rule.sine_of_minimum_crossing_angle = 0; // limbs of one patch
    const auto alone = internal::walk_limb(view, site, internal::Cut<double>(star.local, cosines[l], sines[l]), rule,
                                           [&](const internal::Step<AnyView>& step) { y = step.y; });
    EXPECT_EQ(limbs.end(l), alone.end);
    EXPECT_NEAR(limbs.reached(l), alone.reached, rounding);
    EXPECT_NEAR(limbs.end_along_direction()[l], y, rounding);
    EXPECT_NEAR(gained[l], alone.reached, rounding);
  }
}

/// walks limbs at the angles `first_angle + i * step`, one bundle after the other.
template <typename AnyView>
void expect_same_walks(const AnyView& view, const internal::Site<AnyView>& site, const Vector& normal,
                       Spider::Limb_measure measure, int number_of_limbs, double first_angle = 0.1, double step = 0.77)
{
  const internal::Spider_frame<double> frame(normal, site.reference);
  const internal::Star<AnyView> star(view, site, internal::Local_coordinates<double>(site.point, frame, radius));
  for(int i = 0; i < number_of_limbs; i += internal::number_of_lanes)
  {
    SCOPED_TRACE(i);
    Values cosines, sines;
    for(int l = 0; l < internal::number_of_lanes; ++l)
    {
      cosines.set(l, std::cos(first_angle + step * (i + l)));
      sines.set(l, std::sin(first_angle + step * (i + l)));
    }
    expect_same_walks(view, site, star, cosines, sines, measure,
                      std::min(number_of_limbs - i, internal::number_of_lanes));
  }
}

} // namespace

TEST(limb_bundle, limbs_in_lockstep_end_where_they_do_alone)
{
  for(const auto& [name, mesh] : irregular_noisy_meshes())
  {
    SCOPED_TRACE(name);
    const View view(mesh, mesh.points());
    const Snapshot snapshot = snapshot_of(mesh, view);
    for(Vertex v : mesh.vertices())
      for(Spider::Limb_measure measure : {Spider::arc_length, Spider::tangential_distance})
      {
        const auto site = internal::site_at_vertex(view, v);
        const Vector normal = internal::incident_faces_normal(view, site, radius);
        const int number_of_limbs = 1 + static_cast<int>(v) % most_limbs;
        expect_same_walks(view, site, normal, measure, number_of_limbs);
        expect_same_walks(snapshot, internal::site_at_vertex(snapshot, static_cast<std::uint32_t>(v)), normal, measure,
                          number_of_limbs);
      }
  }
}

TEST(limb_bundle, feature_edges_and_costs_stop_limbs_in_lockstep_as_they_do_alone)
{
  for(auto& [name, mesh] : irregular_noisy_meshes())
  {
    SCOPED_TRACE(name);
    std::mt19937 random(11);
    auto features = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
    auto costs = mesh.add_property_map<Mesh::Face_index, double>("f:cost", 1).first;
    for(auto e : mesh.edges())
      features[e] = random() % 16 == 0;
    for(auto f : mesh.faces())
      costs[f] = random() % 32 == 0 ? std::numeric_limits<double>::infinity() : 1 + double(random() % 3);
    using Attributes = internal::Growth_attributes<decltype(features), decltype(costs)>;
    const internal::Graph_view<Mesh, Point_map, Attributes> view(mesh, mesh.points(),
                                                                 Attributes(features, costs, internal::patch_of_star));
    const Snapshot snapshot = snapshot_of(mesh, view);
    for(Vertex v : mesh.vertices())
      for(Spider::Limb_measure measure : {Spider::arc_length, Spider::tangential_distance})
      {
        const auto site = internal::site_at_vertex(view, v);
        const Vector normal = internal::incident_faces_normal(view, site, radius);
        expect_same_walks(view, site, normal, measure, most_limbs);
        expect_same_walks(snapshot, internal::site_at_vertex(snapshot, static_cast<std::uint32_t>(v)), normal, measure,
                          most_limbs);
      }
  }
}

TEST(limb_bundle, planes_through_vertices_and_along_edges_are_no_exception)
{
  const Mesh mesh = meshes::plane<Mesh>(8, 0.1);
  const View view(mesh, mesh.points());
  for(Vertex v : mesh.vertices())
  {
    auto site = internal::site_at_vertex(view, v);
    site.reference = Vector::UnitX(); // along the edges, from one corner of the grid to the next, and between
    expect_same_walks(view, site, Vector::UnitZ(), Spider::arc_length, most_limbs, 0, meshes::pi / 4);
  }
}

TEST(limb_bundle, a_component_inside_the_sphere_closes)
{
  const Mesh mesh = meshes::icosphere<Mesh>(1, 0.01);
  const View view(mesh, mesh.points());
  for(Vertex v : mesh.vertices())
    for(Spider::Limb_measure measure : {Spider::arc_length, Spider::tangential_distance})
      expect_same_walks(view, internal::site_at_vertex(view, v), meshes::point(mesh, v).normalized(), measure,
                        most_limbs);
}

namespace {

/// The terms of a height field at a point, those above the degree by what turns them: powers of (x + iy).
template <int Degree>
Eigen::VectorXd terms_at(double x, double y)
{
  using Basis = internal::Height_field_basis<Degree>;
  const std::complex<double> z(x, y), square = z * z, cube = square * z, fourth = square * square;
  const double squared = std::norm(z);
  const auto curved = Basis::curved_at(x, y);
  Eigen::VectorXd row(static_cast<int>(Basis::size));
  row << 1, x, y, squared, square.real(), square.imag(), //
    squared * x, squared * y, cube.real(), cube.imag(),  //
    squared * squared, squared * square.real(), squared * square.imag(), fourth.real(), fourth.imag();
  for(int k = 0; k < Basis::curved; ++k)
    row[Basis::linear + k] = curved[k];
  return row;
}

template <int Degree>
void expect_equations_of_all_samples()
{
  using Basis = internal::Height_field_basis<Degree>;
  using Moments = internal::Limb_moments<double, Degree>;
  constexpr int columns = Basis::size + 1; // the values are the last
  std::mt19937 random(3);
  const auto uniform = [&] { return random() / 4294967296.; };

  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(columns, columns);
  Values cosines, sines;
  for(int l = 0; l < internal::number_of_lanes; ++l)
  {
    cosines.set(l, std::cos(1.3 * l));
    sines.set(l, std::sin(1.3 * l));
  }
  Moments moments;
  moments.clear();
  for(int i = 0; i < 5; ++i)
  {
    Values y, weight;
    typename Moments::Functions functions;
    for(int l = 0; l < internal::number_of_lanes; ++l)
    {
      y.set(l, uniform());
      weight.set(l, uniform());
      for(auto& function : functions)
        function.set(l, uniform()); // curved terms are interpolated, so they are no function of y and the angle
      Eigen::VectorXd row(columns);
      row << terms_at<Degree>(y[l] * cosines[l], y[l] * sines[l]), functions[Moments::height][l];
      for(int k = 0; k < Basis::curved; ++k)
        row[Basis::linear + k] = functions[k][l];
      products += weight[l] * row * row.transpose();
    }
    moments.add(y, functions, weight);
  }
  internal::Normal_equations<Values, Basis::size> equations;
  moments.add_to(equations, cosines, sines);
  for(int i = 0; i < columns; ++i)
    for(int k = i; k < columns; ++k)
      EXPECT_NEAR(equations.products[i][k].sum(), products(i, k), 1e-12) << i << ", " << k;
}

} // namespace

TEST(limb_moments, are_the_normal_equations_of_all_samples)
{
  expect_equations_of_all_samples<2>();
  expect_equations_of_all_samples<3>();
  expect_equations_of_all_samples<4>();
}

TEST(height_field, expects_the_same_whichever_way_axes_are_turned_and_of_every_degree)
{
  const double squared_curvature = 0.7;
  // cos^3 and cos^4 of the angle between two points' directions tell how what is expected at one goes with the other's
  const auto expect = [=](auto degree) {
    using Basis = internal::Height_field_basis<decltype(degree)::value>;
    const auto squares = Basis::expected_squares(squared_curvature);
    for(double angle : {0., 0.4, 1., 2.5})
    {
      const Eigen::VectorXd a = terms_at<decltype(degree)::value>(std::cos(0.3), std::sin(0.3)),
                            b = terms_at<decltype(degree)::value>(std::cos(0.3 + angle), std::sin(0.3 + angle));
      double of_cubic = 0, of_quartic = 0;
      for(int i = Basis::quadratic; i < Basis::size; ++i)
        (i < Basis::quartic ? of_cubic : of_quartic) += squares[i - Basis::quadratic] * a[i] * b[i];
      EXPECT_NEAR(of_cubic, std::pow(squared_curvature / 6, 2) * std::pow(std::cos(angle), 3), 1e-12) << angle;
      EXPECT_NEAR(of_quartic, std::pow(squared_curvature, 3) / 36 * std::pow(std::cos(angle), 4), 1e-12) << angle;
    }
  };
  expect(std::integral_constant<int, 2>());
  expect(std::integral_constant<int, 3>());
  expect(std::integral_constant<int, 4>());
}

namespace {

template <int Size, typename System, typename Right_side>
internal::Normal_equations<double, Size> normal_equations_of(const System& system, const Right_side& values)
{
  internal::Normal_equations<double, Size> equations;
  for(int i = 0; i < Size; ++i)
  {
    for(int k = i; k < Size; ++k)
      equations.products[i][k] = system.col(i).dot(system.col(k));
    equations.products[i][Size] = system.col(i).dot(values);
  }
  equations.products[Size][Size] = values.squaredNorm();
  return equations;
}

} // namespace

TEST(least_squares, agrees_with_a_QR_decomposition_and_leaves_out_what_rows_do_not_determine)
{
  constexpr int size = 4;
  std::mt19937 random(5);
  const auto uniform = [&] { return random() / 4294967296.; };
  Eigen::Matrix<double, 12, size> system;
  Eigen::Matrix<double, 12, 1> values;
  for(int i = 0; i < system.rows(); ++i)
  {
    system.row(i) << 1, uniform(), uniform(), 0;
    system(i, 3) = system(i, 1) + 2 * system(i, 2); // nothing new
    values[i] = uniform();
  }
  internal::Elimination<double, size> terms(normal_equations_of<size>(system, values));
  const auto expect_fit_of_first = [&](int count) {
    const Eigen::MatrixXd first = system.leftCols(count);
    const Eigen::VectorXd expected = first.colPivHouseholderQr().solve(values);
    for(int i = 0; i < size; ++i)
    {
      EXPECT_EQ(terms.has(i), i < count);
      EXPECT_NEAR(terms.coefficients()[i], i < count ? expected[i] : 0, 1e-12);
    }
    EXPECT_NEAR(terms.unexplained(), (first * expected - values).squaredNorm(), 1e-12);
    const Eigen::VectorXd of_next =
      system.col(2) - first * first.colPivHouseholderQr().solve(Eigen::VectorXd(system.col(2)));
    if(count < 3)
    {
      EXPECT_NEAR(terms.left_of(2), of_next.squaredNorm(), 1e-12);
    }
    Eigen::VectorXd function(count);
    for(int i = 0; i < count; ++i)
      function[i] = i + 1;
    EXPECT_NEAR(terms.variance({1, 2, 3, 4}), function.dot((first.transpose() * first).inverse() * function), 1e-9);
  };
  terms.eliminate(0, 2);
  expect_fit_of_first(2);
  terms.eliminate(2, size);
  expect_fit_of_first(3);
}

namespace {

template <int Free, int Size>
internal::Elimination<double, Size> beside_free_terms(const internal::Normal_equations<double, Size>& equations)
{
  internal::Elimination<double, Size> terms(equations);
  terms.eliminate(0, Free);
  return terms;
}

} // namespace

TEST(expected_terms, are_damped_as_rows_would_that_say_what_is_expected)
{
  constexpr int size = 4, free = 2, rows = 20;
  std::mt19937 random(11);
  const auto uniform = [&] { return random() / 4294967296. - 0.5; };
  Eigen::MatrixXd system(rows, size);
  Eigen::VectorXd values(rows);
  for(int i = 0; i < rows; ++i)
  {
    const double x = uniform();
    system.row(i) << 1, x, x * x, x * x * x;
    values[i] = 1 + x + 2 * x * x - x * x * x + 0.2 * uniform();
  }
  const auto equations = normal_equations_of<size>(system, values);
  const std::array<double, size - free> expected = {3, 0.5};
  const double noise = 0.01;
  const internal::Expected_terms<free, double, size> terms(beside_free_terms<free>(equations), expected, noise);

  // A row per term says that its coefficient is zero, as surely as noise compares with what is expected.
  Eigen::MatrixXd with_rows = Eigen::MatrixXd::Zero(rows + size - free, size);
  with_rows.topRows(rows) = system;
  for(int i = free; i < size; ++i)
    with_rows(rows + i - free, i) = std::sqrt(noise / expected[i - free]);
  Eigen::VectorXd with_zeros = Eigen::VectorXd::Zero(with_rows.rows());
  with_zeros.head(rows) = values;
  const Eigen::VectorXd coefficients = with_rows.colPivHouseholderQr().solve(with_zeros);
  for(int i = 0; i < size; ++i)
    EXPECT_NEAR(terms.coefficients()[i], coefficients[i], 1e-10);
  EXPECT_NEAR(terms.misfit(terms.coefficients(), expected), (system * coefficients - values).squaredNorm(), 1e-10);
  EXPECT_NEAR(terms.unexplained(), (with_rows * coefficients - with_zeros).squaredNorm(), 1e-10);
  const Eigen::Vector4d function(1, 2, 3, 4);
  EXPECT_NEAR(terms.standard_error({1, 2, 3, 4}),
              std::sqrt(noise * function.dot((with_rows.transpose() * with_rows).inverse() * function)), 1e-10);
}

TEST(expected_terms, leave_the_noise)
{
  constexpr int size = 6, free = 3, rows = 60;
  constexpr int draws = 400;
  std::mt19937 random(13);
  const auto uniform = [&] { return random() / 4294967296. - 0.5; };
  for(double amplitude : {0., 0.01, 1.}) // of noise, with curvature and all higher terms of order 1
  {
    SCOPED_TRACE(amplitude);
    double sum = 0;
    for(int draw = 0; draw < draws; ++draw)
    {
      Eigen::MatrixXd system(rows, size);
      Eigen::VectorXd coefficients(size), values(rows);
      for(int i = 0; i < size; ++i)
        coefficients[i] = std::sqrt(12.) * uniform();
      for(int i = 0; i < rows; ++i)
      {
        const double x = 2 * uniform();
        system.row(i) << 1, x, x * x, x * x * x, x * x * x * x, x * x * x * x * x;
        values[i] = system.row(i) * coefficients + amplitude * std::sqrt(12.) * uniform();
      }
      sum += internal::noise_beside_expected_terms<free, double, size>(
        beside_free_terms<free>(normal_equations_of<size>(system, values)), {1, 1, 1}, rows);
    }
    const double mean = sum / draws;
    EXPECT_NEAR(mean, amplitude * amplitude, 0.1 * amplitude * amplitude + 1e-6) << mean; // measured: 4 % less
  }
}

TEST(spatial_order, holds_every_vertex_once_and_keeps_neighbours_together)
{
  const Mesh mesh = meshes::icosphere<Mesh>(4);
  const View view(mesh, mesh.points());
  const Snapshot snapshot = snapshot_of(mesh, view);
  const std::vector<std::uint32_t> order = internal::spatial_order(snapshot);
  std::vector<bool> seen(order.size(), false);
  double way = 0;
  for(std::size_t i = 0; i < order.size(); ++i)
  {
    EXPECT_FALSE(seen[order[i]]);
    seen[order[i]] = true;
    if(i > 0)
      way += (snapshot.point(order[i]) - snapshot.point(order[i - 1])).norm();
  }
  ASSERT_EQ(order.size(), mesh.number_of_vertices());
  EXPECT_LE(way / order.size(), 0.15); // edges are 0.07 long: measured 0.1
}

// A snapshot stores vertices with the edges that they are seen across: where there is a border, and where a star ends
// at a feature edge, it must know them all the same.
TEST(mesh_snapshot, faces_have_the_vertices_that_they_have_in_the_mesh)
{
  for(auto& [name, mesh] : irregular_noisy_meshes())
  {
    SCOPED_TRACE(name);
    std::mt19937 random(5);
    auto features = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
    for(auto e : mesh.edges())
      features[e] = random() % 8 == 0;
    std::vector<Mesh::Face_index> removed; // so that there are borders, holes, and vertices between two of them
    for(auto f : mesh.faces())
      if(random() % 8 == 0)
        removed.push_back(f);
    for(auto f : removed)
      CGAL::Euler::remove_face(halfedge(f, mesh), mesh);

    using Attributes = internal::Growth_attributes<decltype(features), Spider::internal_np::Param_not_found>;
    const internal::Graph_view<Mesh, Point_map, Attributes> view(mesh, mesh.points(),
                                                                 Attributes(features, {}, internal::patch_of_star));
    const internal::Ranks<Vertex> ranks(vertices(mesh));
    const Snapshot snapshot = snapshot_of(mesh, view);
    std::uint32_t rank = 0;
    for(auto f : mesh.faces())
    {
      std::uint32_t h = snapshot.halfedge(rank++);
      for(auto mesh_h : halfedges_around_face(halfedge(f, mesh), mesh))
      {
        EXPECT_EQ(snapshot.source(h), ranks(source(mesh_h, mesh)));
        EXPECT_EQ(snapshot.target(h), ranks(target(mesh_h, mesh)));
        h = snapshot.other_edges(h).first;
      }
    }
    EXPECT_EQ(snapshot.number_of_faces(), rank);

    for(std::uint32_t v = 0; v < snapshot.number_of_vertices(); ++v)
    {
      if(snapshot.first_corner(v) == Snapshot::null_halfedge())
        continue;
      std::vector<std::pair<std::uint32_t, std::uint32_t>> expected, visited;
      internal::visit_corners(snapshot, snapshot.first_corner(v), [&](std::uint32_t corner) {
        EXPECT_EQ(snapshot.source(corner), v);
        const std::uint32_t edge = snapshot.other_edges(corner).first;
        expected.emplace_back(snapshot.source(edge), snapshot.target(edge));
      });
      snapshot.visit_star(snapshot.first_corner(v),
                          [&](std::uint32_t a, std::uint32_t b) { visited.emplace_back(a, b); });
      EXPECT_EQ(visited, expected);
    }
  }
}
