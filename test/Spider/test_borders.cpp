// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: near borders and holes estimates say what they rest on, and are finite and right wherever they are
// given.

#include "estimation.h"

#include <CGAL/Spider/estimate_curvature.h>

#include <functional>
#include <random>

using namespace estimation;

namespace {

constexpr int directions = 64;
constexpr int n = 20; // the patches are squares of 2n by 2n cells around the origin

Vertex grid_vertex(int i, int j) { return Vertex(static_cast<Mesh::size_type>((2 * n + 1) * (i + n) + j + n)); }

/// returns the share of a full disc's directions' lengths that is left at a distance from a straight border, in radii.
double coverage_near_border(double distance)
{
  if(distance >= 1)
    return 1;
  const double a = std::acos(distance); // directions within this angle of the border's meet it
  const double lost = a - distance * std::log((1 + std::sin(a)) / std::cos(a));
  return 1 - lost / meshes::pi;
}

/// returns the share that is left beside a round hole. Lengths are in radii of the spider.
double coverage_beside_hole(double distance, double hole_radius)
{
  const double widest = std::asin(hole_radius / distance);
  constexpr int steps = 1000;
  double lost = 0;
  for(int i = 0; i < steps; ++i)
  {
    const double angle = widest * (2 * i + 1 - steps) / steps, beside = distance * std::sin(angle);
    const double reached = distance * std::cos(angle) - std::sqrt(hole_radius * hole_radius - beside * beside);
    lost += 2 * widest / steps * (1 - reached);
  }
  return 1 - lost / (2 * meshes::pi);
}

/// returns a mesh without the faces whose centroid is where `is_cut_away(centroid)`. It keeps all vertices.
template <typename Where>
Mesh cut(const Mesh& mesh, Where&& is_cut_away)
{
  Soup soup = soup_of(mesh);
  const auto is_gone = [&](const meshes::Triangle& t) {
    return is_cut_away(Vector((soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]) / 3));
  };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), is_gone), soup.triangles.end());
  return meshes::from_soup<Mesh>(soup.points, soup.triangles);
}

/// returns a mesh without the faces whose centroid is within a distance of a point.
Mesh punched(const Mesh& mesh, const Vector& centre, double hole_radius)
{
  return cut(mesh, [&](const Vector& p) { return (p - centre).norm() < hole_radius; });
}

/// A surface whose mean curvature and upward or outward normal are known, and a mesh of it with a ragged border.
struct Cut_surface
{
  std::string name;
  Mesh mesh;
  std::function<double(const Vector&)> mean_curvature;
  std::function<Vector(const Vector&)> normal;
  double rms_curvature;
};

/// returns a sphere and a saddle, regular and irregular, cut by a plane through the midst of faces.
std::vector<Cut_surface> cut_surfaces()
{
  std::vector<Cut_surface> surfaces;
  const Vector across = Vector(0.8, 0.3, 0.5).normalized();
  const auto is_cut_away = [=](const Vector& p) { return p.dot(across) < -0.1; };
  for(double irregularity : {0., 0.3}) // of an edge
  {
    const std::string kind = irregularity > 0 ? "irregular " : "regular ";
    const Mesh sphere = meshes::icosphere<Mesh>(4);
    const double edge = meshes::mean_edge_length(sphere);
    surfaces.push_back({kind + "sphere",
                        cut(meshes::moved(meshes::jittered(sphere, irregularity * edge, 1),
                                          [](const Vector& p) { return Vector(p.normalized()); }),
                            is_cut_away),
                        [](const Vector&) { return 1.; }, [](const Vector& p) { return Vector(p.normalized()); }, 1});
    const double spacing = 0.05;
    const Mesh saddle = meshes::saddle<Mesh>(n, spacing, 1, -1, meshes::alternating);
    const auto onto_saddle = [](const Vector& p) { return Vector(p.x(), p.y(), (p.x() * p.x() - p.y() * p.y()) / 2); };
    surfaces.push_back(
      {kind + "saddle",
       cut(meshes::moved(meshes::jittered(saddle, irregularity * spacing, 1), onto_saddle), is_cut_away),
       [](const Vector& p) {
         const double xx = p.x() * p.x(), yy = p.y() * p.y();
         return (xx - yy) / (2 * std::pow(1 + xx + yy, 1.5));
       },
       [](const Vector& p) { return Vector(Vector(-p.x(), p.y(), 1).normalized()); }, 0.7});
  }
  return surfaces;
}

/// Mean errors of mean curvature, in units of the RMS curvature.
struct Border_errors
{
  double at_border = 0, inside = 0, worst = 0;
};

/// compares vertices on the border with those that are farther from it than the radius, four edges, with noise along
/// the normals that is uniform and `noise` edges wide.
Border_errors border_errors(const Cut_surface& surface, double noise, unsigned seed)
{
  const double edge = meshes::mean_edge_length(surface.mesh), radius = 4 * edge;
  std::mt19937 random(seed);
  const Mesh noisy = meshes::moved(surface.mesh, [&](const Vector& p) {
    return Vector(p + noise * edge * (random() / 4294967295. - 0.5) * surface.normal(p));
  });
  std::vector<Vector> border;
  for(Vertex v : surface.mesh.vertices())
    if(surface.mesh.is_border(v) && !surface.mesh.is_isolated(v))
      border.push_back(meshes::point(surface.mesh, v));
  const std::vector<Estimate> answers = estimates(noisy, params::geodesic_radius(radius));

  Border_errors errors;
  int at_border = 0, inside = 0;
  for(Vertex v : surface.mesh.vertices())
  {
    const Vector p = meshes::point(surface.mesh, v);
    const double error = std::abs(answers[v].mean_curvature() - surface.mean_curvature(p)) / surface.rms_curvature;
    if(std::isnan(error)) // at the tips of single faces, and without any
      continue;
    errors.worst = std::max(errors.worst, error);
    if(surface.mesh.is_border(v))
    {
      errors.at_border += error;
      ++at_border;
    }
    else if(std::none_of(border.begin(), border.end(), [&](const Vector& b) { return (p - b).norm() < radius; }))
    {
      errors.inside += error;
      ++inside;
    }
  }
  errors.at_border /= at_border;
  errors.inside /= inside;
  return errors;
}

double root_mean_square(const std::vector<double>& values)
{
  double sum = 0;
  for(double x : values)
    sum += x * x;
  return std::sqrt(sum / double(values.size()));
}

} // namespace

TEST(borders, half_a_spider_is_left_at_a_straight_border_and_a_quarter_in_a_corner)
{
  const Mesh plane = meshes::plane<Mesh>(n);
  for_each_setting(5.3, [&](const auto& settings) {
    const auto np = settings.number_of_directions(directions);
    const Estimate at_border = Spider::estimate_curvature(grid_vertex(-n, 0), plane, np);
    EXPECT_EQ(at_border.status, Spider::partial);
    EXPECT_NEAR(at_border.coverage, 0.5, 1.5 / (2 * directions)); // both limbs along the border may count, or neither
    EXPECT_NEAR(at_border.curvedness(), 0, 1e-12);
    const Estimate at_corner = Spider::estimate_curvature(grid_vertex(-n, -n), plane, np);
    EXPECT_NEAR(at_corner.coverage, 0.25, 1.5 / (2 * directions));
    expect_sound(at_corner);
    EXPECT_EQ(Spider::estimate_curvature(grid_vertex(0, 0), plane, np).status, Spider::ok);
  });
}

TEST(borders, coverage_is_the_share_of_the_limbs_that_the_border_leaves)
{
  const Mesh plane = meshes::plane<Mesh>(n);
  const double radius = 6.4;
  for_each_setting(radius, [&](const auto& settings) {
    const auto np = settings.number_of_directions(directions);
    for(int distance = 1; distance <= 8; ++distance)
    {
      const Estimate e = Spider::estimate_curvature(grid_vertex(n - distance, 0), plane, np);
      EXPECT_EQ(e.status, distance < radius ? Spider::partial : Spider::ok);
      EXPECT_NEAR(e.coverage, coverage_near_border(distance / radius), 0.01) << distance;
      EXPECT_NEAR(e.curvedness(), 0, 1e-12);
    }
  });
}

TEST(borders, a_hole_takes_its_share)
{
  const double radius = 5.3;
  const Mesh plane = meshes::plane<Mesh>(n);
  for_each_setting(radius, [&](const auto& settings) {
    const auto np = settings.number_of_directions(directions);
    EXPECT_NEAR(Spider::estimate_curvature(grid_vertex(3, 0), plane, np).coverage, 1, 1e-12);
  });
  const Mesh with_hole = punched(plane, Vector(0, 0, 0), 1.5);
  for_each_setting(radius, [&](const auto& settings) {
    const auto np = settings.number_of_directions(directions);
    const Estimate e = Spider::estimate_curvature(grid_vertex(3, 0), with_hole, np);
    EXPECT_EQ(e.status, Spider::partial);
    // The hole holds a disc of radius 1 and is held by one of radius 2.2.
    EXPECT_LE(e.coverage, coverage_beside_hole(3 / radius, 1 / radius));
    EXPECT_GE(e.coverage, coverage_beside_hole(3 / radius, 2.2 / radius));
    EXPECT_NEAR(e.curvedness(), 0, 1e-12);
    EXPECT_EQ(Spider::estimate_curvature(grid_vertex(8, 0), with_hole, np).status, Spider::ok);
  });
}

TEST(borders, a_hole_far_from_the_point_moves_values_by_less_than_noise_does)
{
  const double spacing = 0.05, edge = 1.14 * spacing; // the mean length in such a grid
  const double noise = 0.25 * edge, radius = 6 * edge;
  const Vertex centre = grid_vertex(0, 0);
  for_each_setting(radius, [&](const auto& np) {
    std::vector<double> errors, moves; // of the least curvature and of the greatest
    for(unsigned seed = 1; seed <= 20; ++seed)
    {
      const Mesh whole =
        meshes::jittered(meshes::saddle<Mesh>(n, spacing, 1, -1, meshes::alternating), noise / 2, seed);
      const Estimate before = Spider::estimate_curvature(centre, whole, np);
      EXPECT_EQ(before.status, Spider::ok);
      errors.insert(errors.end(), {before.min_curvature + 1, before.max_curvature - 1});
      constexpr int holes = 5; // one at a time, two edges wide, and for each seed in directions of its own
      for(int i = 0; i < holes; ++i)
      {
        const double angle = 2 * meshes::pi * (i + seed / 20.) / holes, distance = 2. / 3 * radius;
        const Vector hole = meshes::point(whole, centre) + distance * Vector(std::cos(angle), std::sin(angle), 0);
        const Estimate after = Spider::estimate_curvature(centre, punched(whole, hole, edge), np);
        EXPECT_EQ(after.status, Spider::partial);
        EXPECT_LT(after.coverage, before.coverage - 0.01);
        EXPECT_GT(after.coverage, before.coverage - 0.1);
        moves.insert(moves.end(),
                     {after.min_curvature - before.min_curvature, after.max_curvature - before.max_curvature});
      }
    }
    // Measured: 0.21 of the error as published, 0.26 by default.
    EXPECT_LE(root_mean_square(moves), 0.4 * root_mean_square(errors));
  });
}

TEST(borders, the_curvature_of_a_cylinder_is_found_up_to_its_rim)
{
  const int along = 20;
  const Mesh cylinder = meshes::cylinder<Mesh>(1, 2, 64, along);
  for_each_setting(0.5, [&](const auto& np) {
    for(int row = 0; row <= along; ++row)
    {
      const Estimate e = Spider::estimate_curvature(Vertex(static_cast<Mesh::size_type>(row)), cylinder, np);
      SCOPED_TRACE(row);
      expect_sound(e);
      ASSERT_TRUE(e.is_valid());
      const int to_rim = std::min(row, along - row); // in steps of 0.1: the fifth is at the radius
      if(to_rim != 5)
      {
        EXPECT_EQ(e.status, to_rim < 5 ? Spider::partial : Spider::ok);
      }
      // The paper's fit, which is pulled to the direction it is given, tilts where it sees one side alone. Measured for
      // it: curvature off by 0.44 on the rim, 0.22 next to it, 0.04 inside; the normal by 0.1, 0.054, 0.01.
      const double error = to_rim == 0 ? 0.55 : to_rim == 1 ? 0.28 : to_rim < 5 ? 0.2 : 0.06;
      EXPECT_NEAR(e.max_curvature, 1, error);
      EXPECT_NEAR(e.min_curvature, 0, error);
      EXPECT_LE(angle(vector(e.normal), Vector(1, 0, 0)), to_rim < 2 ? 0.125 : 0.03);
    }
  });
}

TEST(borders, mean_curvature_is_known_at_a_ragged_border_nearly_as_well_as_inside)
{
  for(const Cut_surface& surface : cut_surfaces())
  {
    SCOPED_TRACE(surface.name);
    // Measured: 0.00022 to 0.00053, which is 0.06 to 0.9 times the error inside.
    const Border_errors exact = border_errors(surface, 0, 1);
    EXPECT_LE(exact.at_border, 6e-4);
    EXPECT_LE(exact.at_border, exact.inside);
    // Measured: 2.1 to 3.6 times; a quadric that is fitted to what limbs reach from the border: 3.3 to 4.2.
    double at_border = 0, inside = 0;
    for(unsigned seed = 1; seed <= 4; ++seed)
    {
      const Border_errors noisy = border_errors(surface, 0.25, seed);
      at_border += noisy.at_border;
      inside += noisy.inside;
      EXPECT_LE(noisy.worst, 1); // measured: at most 0.35 to 0.70; the quadric: 0.73 to 1.7
    }
    EXPECT_LE(at_border, 4.5 * inside) << inside;
  }
}

TEST(borders, what_is_farther_than_the_radius_does_not_count)
{
  constexpr double spacing = 0.05, radius = 4 * spacing;
  const Mesh saddle = meshes::jittered(meshes::saddle<Mesh>(n, spacing, 1, -1, meshes::alternating), 0.2 * spacing, 3);
  for(int i = -n; i <= n; i += 5) // along one side, corners included
  {
    const Vertex v(static_cast<Mesh::size_type>((2 * n + 1) * (i + n)));
    const Vector p = meshes::point(saddle, v);
    ASSERT_TRUE(saddle.is_border(v));
    // Triangles that are partly within the radius reach no farther than an edge beyond it.
    const Mesh changed = meshes::moved(saddle, [&](const Vector& q) {
      return Vector((q - p).head<2>().norm() > radius + 2 * spacing ? Vector(q + 0.3 * Vector::UnitZ()) : q);
    });
    const auto np = params::geodesic_radius(radius).number_of_directions(16).first_normal(Spider::incident_faces);
    const Estimate before = Spider::estimate_curvature(v, saddle, np),
                   after = Spider::estimate_curvature(v, changed, np);
    EXPECT_EQ(before.status, Spider::partial);
    EXPECT_EQ(before.min_curvature, after.min_curvature);
    EXPECT_EQ(before.max_curvature, after.max_curvature);
  }
}

TEST(borders, every_vertex_of_a_noisy_patch_gets_a_sound_answer)
{
  const Mesh patch = meshes::jittered(meshes::saddle<Mesh>(8, 0.1, 1.5, -0.5, meshes::alternating), 0.03, 6);
  for_each_setting(0.6, [&](const auto& np) {
    int valid = 0;
    for(const Estimate& e : estimates(patch, np))
    {
      expect_sound(e);
      EXPECT_NE(e.status, Spider::isolated);
      EXPECT_TRUE(vector(e.normal).allFinite());
      EXPECT_GT(e.coverage, 0.1);
      valid += e.is_valid();
    }
    EXPECT_GE(valid, 289 - 4); // of 17 x 17, the corners aside
  });
}

TEST(borders, a_radius_beyond_the_mesh_is_partial)
{
  const Mesh patch = meshes::saddle<Mesh>(8, 0.1, 1.5, -0.5);
  for_each_setting(100., [&](const auto& np) {
    const Estimate e = Spider::estimate_curvature(Vertex(17 * 8 + 8), patch, np);
    expect_sound(e);
    EXPECT_NE(e.status, Spider::ok);
    EXPECT_LT(e.coverage, 0.02);
  });
}
