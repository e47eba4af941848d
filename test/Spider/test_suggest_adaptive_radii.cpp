// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: on shapes of mixed scale, radii that follow the shape do better than any one radius: the error of mean
// curvature that one vertex in twenty exceeds. Surfaces have vertices moved by uniform noise in all coordinates; every
// bound has beside it what was measured over seeds 1 to 5, mean and standard deviation.

#include "estimation.h"

#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/suggest_adaptive_radii.h>

#include <functional>
#include <limits>
#include <random>

using namespace estimation;

namespace {

using Parametrization = std::function<Vector(double u, double v)>;

/// returns the mean curvature of a parametrized surface, by differences.
double mean_curvature(const Parametrization& f, double u, double v)
{
  const double h = 1e-4;
  const Vector p = f(u, v), fu = (f(u + h, v) - f(u - h, v)) / (2 * h), fv = (f(u, v + h) - f(u, v - h)) / (2 * h);
  const Vector fuu = (f(u + h, v) - 2 * p + f(u - h, v)) / (h * h), fvv = (f(u, v + h) - 2 * p + f(u, v - h)) / (h * h);
  const Vector fuv = (f(u + h, v + h) - f(u - h, v + h) - f(u + h, v - h) + f(u - h, v - h)) / (4 * h * h);
  const Vector n = fu.cross(fv).normalized();
  const double E = fu.dot(fu), F = fu.dot(fv), G = fv.dot(fv);
  return -(E * fvv.dot(n) - 2 * F * fuv.dot(n) + G * fuu.dot(n)) / (2 * (E * G - F * F));
}

struct Surface
{
  Mesh mesh;
  std::map<Vertex, double> mean_curvatures; ///< those that are judged
  double edge_length;
};

/// returns an irregular mesh, with noise of up to half of its mean edge length times `noise`.
Surface noisy_surface(const Parametrization& f, int nu, int nv, double du, double dv, bool wraps, double noise,
                      unsigned seed)
{
  std::mt19937 random(seed);
  const auto uniform = [&] { return random() / 4294967295. - 0.5; };
  std::vector<std::array<double, 2>> parameters;
  const auto place = [&](int i, int j) {
    parameters.push_back({(i + 0.6 * uniform()) * du, (j + 0.6 * uniform()) * dv});
    return f(parameters.back()[0], parameters.back()[1]);
  };
  Surface surface;
  surface.mesh = meshes::patch<Mesh>(nu, nv, place, meshes::alternating, wraps, wraps);
  surface.edge_length = meshes::mean_edge_length(surface.mesh);
  constexpr int margin = 12; // vertices at borders are another matter
  const int columns = wraps ? nv : nv + 1;
  for(Vertex v : surface.mesh.vertices())
  {
    const int i = int(v.idx()) / columns, j = int(v.idx()) % columns;
    const bool is_inside = i >= margin && j >= margin && i <= nu - margin && j <= nv - margin;
    if(wraps || is_inside)
      surface.mean_curvatures[v] = mean_curvature(f, parameters[v.idx()][0], parameters[v.idx()][1]);
  }
  surface.mesh = meshes::moved(std::move(surface.mesh), [&](const Vector& p) {
    const double x = uniform(), y = uniform(), z = uniform();
    return Vector(p + noise * surface.edge_length * Vector(x, y, z));
  });
  return surface;
}

/// a graph with long waves on one side and short ones on the other
Surface waves_of_two_lengths(double noise, unsigned seed)
{
  const auto f = [](double x, double y) {
    const double share = 1 / (1 + std::exp(-4 * (x - 5)));
    return Vector(x, y, (1 - share) * 0.4 * std::sin(1.1 * x) + share * 0.03 * std::sin(4.5 * x) * std::cos(2 * y));
  };
  return noisy_surface(f, 100, 80, 0.1, 0.1, false, noise, seed);
}

/// a torus whose tube has teeth on one side and a slow wave on the other
Surface gear(double noise, unsigned seed)
{
  const auto f = [](double u, double v) {
    const double share = 0.5 + 0.5 * std::tanh(3 * std::sin(u));
    const double r = 1 + (1 - share) * 0.06 * std::sin(2 * u) + share * 0.04 * std::sin(20 * u);
    const double distance = 3 + r * std::cos(v);
    return Vector(distance * std::cos(u), distance * std::sin(u), r * std::sin(v));
  };
  return noisy_surface(f, 240, 80, 2 * meshes::pi / 240, 2 * meshes::pi / 80, true, noise, seed);
}

/// a plain with sharp tips
Surface tips(double noise, unsigned seed)
{
  const auto f = [](double x, double y) {
    double z = 0;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        z += 0.25 * std::exp(-(std::pow(x - 2 - 3 * i, 2) + std::pow(y - 2 - 3 * j, 2)) / (2 * 0.35 * 0.35));
    return Vector(x, y, z);
  };
  return noisy_surface(f, 100, 100, 0.1, 0.1, false, noise, seed);
}

/// returns the error that one vertex in twenty exceeds.
template <typename NamedParameters>
double error_with(const Surface& surface, const NamedParameters& np)
{
  std::map<Vertex, Estimate> estimates;
  Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(surface.mesh,
                                                                      boost::make_assoc_property_map(estimates), np);
  std::vector<double> errors;
  for(const auto& [v, H] : surface.mean_curvatures)
    errors.push_back(std::abs(estimates.at(v).mean_curvature() - H));
  const auto at = errors.begin() + errors.size() * 95 / 100;
  std::nth_element(errors.begin(), at, errors.end());
  return *at;
}

double error_of_suggested_radii(const Surface& surface)
{
  std::map<Vertex, double> radii;
  const auto map = boost::make_assoc_property_map(radii);
  Spider::suggest_adaptive_radii<CGAL::Parallel_if_available_tag>(surface.mesh, map);
  return error_with(surface, params::geodesic_radius(map));
}

struct Limbs
{
  std::map<Vertex, double> radii;
  std::map<Vertex, Kernel::Vector_3> elongations;
};

template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag>
Limbs suggested_limbs(const Mesh& mesh)
{
  Limbs limbs;
  Spider::suggest_adaptive_radii<ConcurrencyTag>(
    mesh, boost::make_assoc_property_map(limbs.radii),
    params::limb_elongation_map(boost::make_assoc_property_map(limbs.elongations)));
  return limbs;
}

double error_of_suggested_limbs(const Surface& surface)
{
  Limbs limbs = suggested_limbs(surface.mesh);
  return error_with(surface, params::geodesic_radius(boost::make_assoc_property_map(limbs.radii))
                               .limb_elongation_map(boost::make_assoc_property_map(limbs.elongations)));
}

double error_of_best_fixed_radius(const Surface& surface)
{
  double least = std::numeric_limits<double>::infinity();
  for(double edges : {2., 2.5, 3., 3.5, 4., 5., 6., 8.}) // more is worse on all of these shapes
    least = std::min(least, error_with(surface, params::geodesic_radius(edges * surface.edge_length)));
  return least;
}

double ratio(const Surface& surface) { return error_of_suggested_radii(surface) / error_of_best_fixed_radius(surface); }

double ratio_by_direction(const Surface& surface)
{
  return error_of_suggested_limbs(surface) / error_of_best_fixed_radius(surface);
}

} // namespace

TEST(suggest_adaptive_radii, beat_every_fixed_radius_on_waves_of_two_lengths)
{
  EXPECT_LT(ratio(waves_of_two_lengths(0.25, 1)), 1);   // measured 0.962, and 0.985 for another seed
  EXPECT_LT(ratio(waves_of_two_lengths(0.5, 2)), 1.06); // with much noise they are as good: 0.991 and 1.031
}

TEST(suggest_adaptive_radii, beat_every_fixed_radius_on_a_gear)
{
  EXPECT_LT(ratio(gear(0.25, 1)), 0.95); // measured 0.915, and 0.919 for another seed
}

TEST(suggest_adaptive_radii, beat_every_fixed_radius_on_tips)
{
  EXPECT_LT(ratio(tips(0.5, 2)), 1); // measured 0.977, and 0.976 for another seed
}

TEST(suggest_adaptive_radii, are_small_where_a_surface_bends_at_a_small_scale)
{
  const Surface surface = waves_of_two_lengths(0.5, 3);
  std::map<Vertex, double> radii;
  Spider::suggest_adaptive_radii(surface.mesh, boost::make_assoc_property_map(radii));
  double of_long = 0, of_short = 0;
  for(const auto& [v, H] : surface.mean_curvatures)
  {
    const double x = surface.mesh.point(v).x();
    of_long += x < 4 ? radii.at(v) : 0;
    of_short += x > 6 ? radii.at(v) : 0;
  }
  EXPECT_GT(of_long, 1.5 * of_short); // 1.91 +- 0.08, over as many vertices
}

TEST(suggest_adaptive_radii, by_direction_beat_every_fixed_radius)
{
  // Beside each: what was measured, and the most for two other seeds.
  EXPECT_LT(ratio_by_direction(waves_of_two_lengths(0.25, 2)), 1); // 0.951, 0.931
  EXPECT_LT(ratio_by_direction(waves_of_two_lengths(0.5, 2)), 1);  // 0.942, 0.943
  EXPECT_LT(ratio_by_direction(gear(0.25, 2)), 0.85);              // 0.788, 0.798
  EXPECT_LT(ratio_by_direction(gear(0.5, 2)), 0.85);               // 0.803, 0.820
  EXPECT_LT(ratio_by_direction(tips(0.5, 2)), 1);                  // 0.983, 0.984
}

TEST(suggest_adaptive_radii, by_direction_follow_the_teeth_of_a_gear)
{
  const Surface surface = gear(0.25, 3);
  const Limbs limbs = suggested_limbs(surface.mesh);
  double along = 0, length = 0;
  int count = 0;
  for(Vertex v : surface.mesh.vertices())
  {
    const auto p = surface.mesh.point(v);
    const double u = std::atan2(p.y(), p.x()), distance = std::hypot(p.x(), p.y()) - 3, w = std::atan2(p.z(), distance);
    if(std::sin(u) < 0.5 || distance > 0) // teeth are on the other half; outside they are as wide as the tube
      continue;
    const Vector tooth(-std::sin(w) * std::cos(u), -std::sin(w) * std::sin(u), std::cos(w));
    const Vector elongation = vector(limbs.elongations.at(v));
    along += std::abs(elongation.normalized().dot(tooth));
    length += elongation.norm();
    ++count;
  }
  EXPECT_GT(along / count, 0.98); // measured 0.998
  EXPECT_GT(length / count, 1.3); // 1.51
}

TEST(suggest_adaptive_radii, by_direction_are_those_of_ellipses_as_large_as_discs)
{
  const Surface surface = waves_of_two_lengths(0.25, 3);
  std::map<Vertex, double> radii;
  Spider::suggest_adaptive_radii(surface.mesh, boost::make_assoc_property_map(radii));
  const Limbs limbs = suggested_limbs<CGAL::Sequential_tag>(surface.mesh);
  for(Vertex v : surface.mesh.vertices())
  {
    const double length = std::sqrt(limbs.elongations.at(v).squared_length());
    ASSERT_GE(length, 1 - 1e-12);
    ASSERT_LE(length, 2 + 1e-12);
    ASSERT_NEAR(limbs.radii.at(v), std::sqrt(length) * radii.at(v), 1e-12 * radii.at(v));
  }
  const Limbs in_threads = suggested_limbs(surface.mesh);
  EXPECT_EQ(in_threads.radii, limbs.radii);
  EXPECT_EQ(in_threads.elongations, limbs.elongations);
}
