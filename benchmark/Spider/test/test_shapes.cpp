// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Surface.h"

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/math/constants/constants.hpp>

#include <gtest/gtest.h>

using namespace CGAL::Spider::benchmark;

namespace {

class Shapes : public testing::TestWithParam<std::string>
{
protected:
  Shape_ptr shape = make_shape(GetParam());

  Surface irregular_surface(std::size_t number_of_vertices) const
  {
    Recipe recipe;
    recipe.shape = GetParam();
    recipe.tessellation = Tessellation::irregular;
    recipe.number_of_vertices = number_of_vertices;
    return make_surface(recipe);
  }
};

INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::ValuesIn(shape_names()), [](const auto& info) { return info.param; });

// The curvature that three points of the surface show, the outer two a small step along and against a direction: their
// middle lies step^2 / 2 times the curvature under the surface. Only the shape's points are used, not its derivatives.
double measured_curvature(const Shape& shape, const Point& p, const Vector& direction, const Vector& normal)
{
  constexpr double step = 1e-3; // truncation and rounding are then both near 1e-6 and 1e-10 of the curvature
  const Point ahead = shape.project(p + step * direction), behind = shape.project(p - step * direction);
  return 2 * ((p - CGAL::midpoint(ahead, behind)) * normal) / (CGAL::squared_distance(ahead, behind) / 4);
}

TEST_P(Shapes, ShowTheirPrincipalCurvaturesByTheirPoints)
{
  const Surface surface = irregular_surface(1000);
  for(auto v : surface.mesh.vertices())
  {
    const Estimate& truth = surface.truth[v];
    const Point& p = surface.mesh.point(v);
    EXPECT_NEAR(measured_curvature(*shape, p, truth.min_direction, truth.normal), truth.min_curvature, 1e-4);
    EXPECT_NEAR(measured_curvature(*shape, p, truth.max_direction, truth.normal), truth.max_curvature, 1e-4);
    // Euler: half-way between them the curvature is their mean, unless the directions are wrong
    const Vector between = (truth.min_direction + truth.max_direction) / std::sqrt(2.);
    EXPECT_NEAR(measured_curvature(*shape, p, between, truth.normal), truth.mean_curvature(), 1e-4);
  }
}

TEST_P(Shapes, HaveRightHandedOrthonormalFrames)
{
  for(const Estimate& truth : irregular_surface(1000).truth)
  {
    EXPECT_LE(truth.min_curvature, truth.max_curvature);
    EXPECT_NEAR(truth.min_direction.squared_length(), 1, 1e-12);
    EXPECT_NEAR(truth.max_direction.squared_length(), 1, 1e-12);
    const Vector cross = CGAL::cross_product(truth.min_direction, truth.max_direction);
    EXPECT_NEAR((cross - truth.normal).squared_length(), 0, 1e-24);
  }
}

TEST_P(Shapes, KeepTheirVerticesOnTheSurface)
{
  const Surface surface = irregular_surface(1000);
  for(const Point& p : surface.mesh.points())
    EXPECT_NEAR(shape->level(p).value, 0, 1e-14);
}

// The integral of K over a closed surface is 2 pi times its Euler characteristic; the sum over flat triangles gets
// there by the square of the edge length, that is, in inverse proportion to the number of vertices.
TEST_P(Shapes, SatisfyGaussAndBonnet)
{
  const auto error = [&](std::size_t number_of_vertices) {
    const Surface surface = irregular_surface(number_of_vertices);
    double integral = 0;
    for(auto face : surface.mesh.faces())
      for(auto v : surface.mesh.vertices_around_face(surface.mesh.halfedge(face)))
        integral +=
          surface.truth[v].Gaussian_curvature() * CGAL::Polygon_mesh_processing::face_area(face, surface.mesh) / 3;
    const double euler = static_cast<double>(surface.mesh.number_of_vertices()) -
                         static_cast<double>(surface.mesh.number_of_edges()) +
                         static_cast<double>(surface.mesh.number_of_faces());
    return std::abs(integral - euler * boost::math::constants::two_pi<double>());
  };
  if(!CGAL::is_closed(irregular_surface(1000).mesh))
    GTEST_SKIP() << "has a border";
  const double coarse = error(2500), fine = error(10000);
  // measured at 2500: 0.03 (sphere) to 0.19 (ellipsoid), and a quarter of that at 10,000
  EXPECT_LT(coarse, 0.3);
  EXPECT_LT(fine, coarse / 3);
}

TEST(Shape, KnowsTheCurvatureOfTheSphere)
{
  const Estimate truth = make_shape("sphere")->truth(Point(0, 0, 1));
  EXPECT_DOUBLE_EQ(truth.min_curvature, 1);
  EXPECT_DOUBLE_EQ(truth.max_curvature, 1);
  EXPECT_EQ(truth.normal, Vector(0, 0, 1));
}

TEST(Shape, KnowsTheCurvatureOfTheTorusAtItsEquators)
{
  const Shape_ptr torus = make_shape("torus");
  const Estimate outer = torus->truth(Point(1.4, 0, 0)), inner = torus->truth(Point(0.6, 0, 0));
  EXPECT_DOUBLE_EQ(outer.max_curvature, 2.5);
  EXPECT_DOUBLE_EQ(outer.min_curvature, 1 / 1.4);
  EXPECT_NEAR(std::abs(outer.max_direction.z()), 1, 1e-15);
  EXPECT_DOUBLE_EQ(inner.max_curvature, 2.5);
  EXPECT_DOUBLE_EQ(inner.min_curvature, -1 / 0.6);
}

TEST(Shape, KnowsTheCurvatureOfTheSaddleAtItsCentre)
{
  const Estimate truth = make_shape("saddle")->truth(Point(0, 0, 0));
  EXPECT_DOUBLE_EQ(truth.min_curvature, -1); // along x the surface bends up, to its normal
  EXPECT_DOUBLE_EQ(truth.max_curvature, 1);
  EXPECT_NEAR(std::abs(truth.min_direction.x()), 1, 1e-15);
}

TEST(Shape, SaysWhichShapesThereAre) { EXPECT_THROW(make_shape("teapot"), std::invalid_argument); }

} // namespace
