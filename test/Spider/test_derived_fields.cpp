// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Spider/derived_fields.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/extract_isolines.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <map>

using namespace estimation;

namespace {

/// returns an estimate with curvatures 1 along x and 3 along y.
Estimate ridge()
{
  Estimate e;
  e.min_curvature = 1;
  e.max_curvature = 3;
  e.min_direction = Kernel::Vector_3(1, 0, 0);
  e.max_direction = Kernel::Vector_3(0, 1, 0);
  e.normal = Kernel::Vector_3(0, 0, 1);
  e.status = Spider::ok;
  return e;
}

} // namespace

TEST(derived_fields, are_those_of_the_estimate)
{
  const std::map<int, Estimate> curvature = {{7, ridge()}};
  const boost::const_associative_property_map<std::map<int, Estimate>> map(curvature);
  EXPECT_EQ(get(Spider::derived_field(map, Spider::Mean_curvature()), 7), 2);
  EXPECT_EQ(get(Spider::derived_field(map, Spider::Gaussian_curvature()), 7), 3);
  EXPECT_DOUBLE_EQ(get(Spider::derived_field(map, Spider::Shape_index()), 7), std::atan2(4, 2) / (meshes::pi / 2));
  EXPECT_DOUBLE_EQ(get(Spider::derived_field(map, Spider::Curvedness()), 7), std::sqrt(5.));
  const auto own = [](const Estimate& e) { return e.max_curvature - e.min_curvature; };
  EXPECT_EQ(get(Spider::derived_field(map, own), 7), 2);
}

TEST(derived_fields, radial_curvature_is_the_normal_curvature_where_the_viewer_is)
{
  const Spider::Radial_curvature radial;
  for(double height : {0., 1., -1e6})
    for(double size : {1e-200, 1., 1e200})
    {
      const auto seen_from = [&](double x, double y) {
        return radial(ridge(), Kernel::Vector_3(size * x, size * y, size * height));
      };
      EXPECT_NEAR(seen_from(1, 0), 1, 1e-12);
      EXPECT_NEAR(seen_from(0, -2), 3, 1e-12);
      EXPECT_NEAR(seen_from(-1, 1), 2, 1e-12);
      EXPECT_NEAR(seen_from(0.5, std::sqrt(0.75)), 2.5, 1e-12); // Euler: cos² of 60 degrees is 1/4
    }
  // of any kernel
  EXPECT_NEAR(radial(ridge(), CGAL::Exact_predicates_exact_constructions_kernel::Vector_3(1, 1, 5)), 2, 1e-15);
  EXPECT_NEAR(radial(ridge(), Vector(1, 1, 5)), 2, 1e-15);
}

TEST(derived_fields, radial_curvature_is_not_a_number_where_it_has_no_value)
{
  const Spider::Radial_curvature radial;
  EXPECT_TRUE(std::isnan(radial(ridge(), Vector(0, 0, 1))));
  EXPECT_TRUE(std::isnan(radial(ridge(), Vector(0, 0, 0))));
  EXPECT_TRUE(std::isnan(radial(Estimate(), Vector(1, 2, 3))));
}

// The definition that DeCarlo et al. start from: along the tangential part w of the view vector v, the product n·v
// changes by the radial curvature times w².
TEST(derived_fields, radial_curvature_is_how_fast_a_surface_turns_away_from_the_viewer)
{
  const Mesh mesh = meshes::saddle<Mesh>(30, 0.02, 1.5, -0.5);
  std::map<Vertex, Estimate> curvature;
  Spider::estimate_vertex_curvatures(mesh, boost::make_assoc_property_map(curvature), params::polynomial_degree(4));
  const Kernel::Point_3 viewer(2, 1, 3);
  const auto radial = Spider::radial_curvature_field(boost::make_assoc_property_map(curvature), mesh.points(), viewer);

  const auto point = [](double x, double y) { return Vector(x, y, (1.5 * x * x - 0.5 * y * y) / 2); };
  const auto normal = [](double x, double y) { return Vector(-1.5 * x, 0.5 * y, 1).normalized(); };
  const auto facing = [&](const Vector& p) { return normal(p.x(), p.y()).dot(vector(viewer) - point(p.x(), p.y())); };
  for(Vertex v : mesh.vertices())
  {
    if(curvature[v].status != Spider::ok)
      continue;
    const Vector p = meshes::point(mesh, v), n = normal(p.x(), p.y()), view = vector(viewer) - p;
    const Vector w = view - view.dot(n) * n;
    constexpr double step = 1e-4;
    const double change = (facing(p + step * w) - facing(p - step * w)) / (2 * step);
    EXPECT_NEAR(get(radial, v), change / w.squaredNorm(), 1e-3);
  }
}

TEST(derived_fields, have_isolines)
{
  // The parabolic lines of a torus are the circles at its top and its bottom.
  const Mesh mesh = meshes::torus<Mesh>(1, 0.4, 80, 41);
  std::map<Vertex, Estimate> curvature;
  const auto map = boost::make_assoc_property_map(curvature);
  Spider::estimate_vertex_curvatures(mesh, map);
  std::vector<Spider::Isoline_3<Mesh>> lines;
  Spider::extract_isolines(mesh, Spider::derived_field(map, Spider::Gaussian_curvature()), 0,
                           std::back_inserter(lines));
  ASSERT_EQ(lines.size(), 2u);
  for(const auto& line : lines)
  {
    EXPECT_TRUE(line.is_closed);
    for(const auto& p : line.points)
    {
      EXPECT_NEAR(std::abs(p.z()), 0.4, 0.02);
      EXPECT_NEAR(std::hypot(p.x(), p.y()), 1, 0.03);
    }
  }
}
