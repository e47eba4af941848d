// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../estimators/Meyer_2003.h"
#include "test_meshes.h"

#include <gtest/gtest.h>

using namespace CGAL::Spider::benchmark;
using namespace CGAL::Spider::benchmark::test;

namespace {

using Smoothing = Meyer_2003::Smoothing;

std::vector<Estimate> meyer(const Mesh& mesh, Smoothing smoothing = Smoothing::none)
{
  return estimates(Meyer_2003(smoothing), mesh);
}

// The objective of Constrained_direction_fit, at an angle.
struct Sample
{
  Vector edge;
  double weight;
};

double objective(const std::vector<Sample>& samples, double mean, double deviation, double angle)
{
  double sum = 0;
  for(const Sample& s : samples)
  {
    const double normal_curvature = -2 * s.edge.z() / s.edge.squared_length();
    const double fitted = mean + deviation * std::cos(2 * (std::atan2(s.edge.y(), s.edge.x()) - angle));
    sum += s.weight * (fitted - normal_curvature) * (fitted - normal_curvature);
  }
  return sum;
}

} // namespace

// Meyer et al., section 3.5 and 4: on a regular mesh of a sphere the errors of H and K go down at least with h^2.
TEST(Meyer_2003, ConvergesOnASphere)
{
  const double radius = 2, H = 1 / radius, K = H * H;
  const Mesh coarse = make_sphere(3, radius), fine = make_sphere(4, radius);
  const std::vector<Estimate> on_coarse = meyer(coarse), on_fine = meyer(fine);
  EXPECT_GT(order(mean_error(on_coarse, coarse.vertices(), H, mean), mean_error(on_fine, fine.vertices(), H, mean)), 2);
  EXPECT_GT(
    order(mean_error(on_coarse, coarse.vertices(), K, Gaussian), mean_error(on_fine, fine.vertices(), K, Gaussian)), 2);
  EXPECT_LT(worst_error(on_fine, fine.vertices(), H, mean), 1e-5); // measured: 2.5e-6
}

// On a cylinder cut by lines along and across, the angles add up to 2 pi, and H is exact too: the Laplacian is twice
// the chord's sagitta over the squared chord, which is 1/R whatever the chord.
TEST(Meyer_2003, IsExactOnACylinder)
{
  const int cells = 24;
  const double radius = 2;
  const Mesh mesh = make_cylinder(cells, radius);
  const std::vector<Estimate> all = meyer(mesh);
  for(Mesh::Vertex_index v : inner_vertices(cells))
  {
    EXPECT_NEAR(all[v.idx()].min_curvature, 0, 1e-12);
    EXPECT_NEAR(all[v.idx()].max_curvature, 1 / radius, 1e-12);
    EXPECT_NEAR(line_angle(all[v.idx()].min_direction, Vector(0, 1, 0)), 0, 1e-5); // root of the rounding
  }
}

TEST(Meyer_2003, ConvergesInTheMiddleOfASaddle)
{
  struct Errors
  {
    double curvatures, angle;
  };
  const auto errors = [](int cells) {
    const Mesh mesh = make_graph(cells, [](double x, double y) { return (x * x - 2 * y * y) / 2; });
    const Estimate e = meyer(mesh)[middle_vertex(cells).idx()];
    return Errors{std::abs(e.max_curvature - 2) + std::abs(e.min_curvature + 1),
                  line_angle(e.max_direction, Vector(0, 1, 0))};
  };
  const Errors coarse = errors(20), fine = errors(40);
  EXPECT_NEAR(order(coarse.curvatures, fine.curvatures), 2, 0.1);
  EXPECT_NEAR(order(coarse.angle, fine.angle), 2, 0.1);
  EXPECT_LT(fine.angle, 1e-3); // measured: 4.9e-4
}

// The corner of a cube, cut off: three right angles, so half of each of three faces of area 1/2; the cotangents that
// belong to the three unit edges are all 1. There H^2 < K, which no surface can have: both curvatures are H then.
TEST(Meyer_2003, IsAsComputedByHandAtACorner)
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  const std::vector<Estimate> all = meyer(mesh);
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    if(mesh.point(v) != Point(0, 0, 0))
      continue;
    const double area = 3. / 4, H = std::sqrt(3.) / (2 * area); // |(1, 0, 0) + (0, 1, 0) + (0, 0, 1)| / 2A
    EXPECT_NEAR(all[v.idx()].min_curvature, H, 1e-12);
    EXPECT_NEAR(all[v.idx()].max_curvature, H, 1e-12);
  }
}

// A quarter of an obtuse face at each acute corner and a half at the obtuse one (figure 4), by the flat star's defect
// after its centre has been lifted: K = defect / A.
TEST(Meyer_2003, SharesObtuseFacesOut)
{
  // a flat pyramid on a wide triangle: all three faces are obtuse at the apex
  const double lift = 0.1;
  const std::vector<Point> base{Point(-1, -1, 0), Point(1, -1, 0), Point(0, 1, 0)};
  Mesh mesh;
  CGAL::make_tetrahedron(base[0], base[2], base[1], Point(0, -0.3, lift), mesh);
  const std::vector<Estimate> all = meyer(mesh);
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    if(mesh.point(v).z() == 0)
      continue;
    double angles = 0, area = 0;
    for(int i = 0; i < 3; ++i)
    {
      const Vector a = base[i] - mesh.point(v), b = base[(i + 1) % 3] - mesh.point(v);
      EXPECT_LT(a * b, 0);
      const double doubled = std::sqrt(CGAL::cross_product(a, b).squared_length());
      angles += std::atan2(doubled, a * b);
      area += doubled / 4; // half of the face
    }
    const double K = (2 * CGAL_PI - angles) / area;
    const double H = all[v.idx()].mean_curvature();
    EXPECT_NEAR(all[v.idx()].max_curvature - H, std::sqrt((std::max)(0., H * H - K)), 1e-12);
    EXPECT_GT(H * H, K); // so that K does show
  }
}

TEST(Meyer_2003, SaysNothingOnTheBorder)
{
  const Mesh mesh = make_cylinder(8);
  const std::vector<Estimate> all = meyer(mesh), smoothed = meyer(mesh, Smoothing::laplacian);
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    EXPECT_EQ(std::isnan(all[v.idx()].max_curvature), mesh.is_border(v));
    EXPECT_EQ(std::isnan(smoothed[v.idx()].max_curvature), mesh.is_border(v));
  }
}

// Ten rounds of f += 0.2 (mean of the neighbours - f), by hand, on a mesh where H and K vary.
TEST(Meyer_2003, SmoothsTheFieldsOfHAndK)
{
  const int cells = 12;
  const Mesh mesh = make_graph(
    cells, [](double x, double y) { return (x * x + y * y) / 2; }, 0.1);
  const std::vector<Estimate> rough = meyer(mesh), smooth = meyer(mesh, Smoothing::laplacian);
  std::vector<double> H, K;
  for(const Estimate& e : rough)
  {
    H.push_back(e.mean_curvature());
    K.push_back(e.Gaussian_curvature());
  }
  for(std::vector<double>* field : {&H, &K})
    for(int round = 0; round < 10; ++round)
    {
      const std::vector<double> before = *field;
      for(Mesh::Vertex_index v : mesh.vertices())
      {
        double sum = 0;
        int count = 0;
        for(Mesh::Vertex_index w : mesh.vertices_around_target(mesh.halfedge(v)))
          if(!mesh.is_border(w))
          {
            sum += before[w.idx()];
            ++count;
          }
        if(count > 0)
          (*field)[v.idx()] += 0.2 * (sum / count - before[v.idx()]);
      }
    }
  for(Mesh::Vertex_index v : inner_vertices(cells))
  {
    EXPECT_NEAR(smooth[v.idx()].mean_curvature(), H[v.idx()], 1e-12);
    EXPECT_NE(smooth[v.idx()].mean_curvature(), rough[v.idx()].mean_curvature());
  }
}

TEST(Constrained_direction_fit, FindsTheAngleOfExactCurvatures)
{
  const Tangent_frame frame(Vector(0, 0, 1));
  const double H = 0.5, D = 1.25;
  for(double angle : {-1.2, -0.3, 0., 0.7, 1.5})
  {
    Constrained_direction_fit fit;
    for(int i = 0; i < 5; ++i)
    {
      const double t = 0.3 + i * 1.1, curvature = H + D * std::cos(2 * (t - angle));
      // the circle of that curvature through the origin, an edge of it whose tangential part is 0.1
      const double z = curvature == 0 ? 0 : -(1 - std::sqrt(1 - curvature * curvature * 0.01)) / curvature;
      fit.add(frame, 0.1 * std::cos(t) * frame.u + 0.1 * std::sin(t) * frame.v + z * frame.normal, 1 + i, H);
    }
    EXPECT_NEAR(std::remainder(fit.angle(D) - angle, CGAL_PI), 0, 1e-12);
  }
}

// Against a search over all angles, for values that no tensor fits.
TEST(Constrained_direction_fit, IsTheLeastSquaresFit)
{
  std::mt19937 random(3);
  const auto uniform = [&] { return double(random()) / double(std::mt19937::max()); };
  const Tangent_frame frame(Vector(0, 0, 1));
  for(int trial = 0; trial < 100; ++trial)
  {
    const double H = 2 * uniform() - 1, D = 2 * uniform();
    Constrained_direction_fit fit;
    std::vector<Sample> samples;
    for(int i = 0; i < 6; ++i)
    {
      const double x = uniform() - 0.5, y = uniform() - 0.5, z = uniform() - 0.5;
      const Vector local(x, y, z);
      samples.push_back({local, uniform()});
      fit.add(frame, local.x() * frame.u + local.y() * frame.v + local.z() * frame.normal, samples.back().weight, H);
    }
    double least = std::numeric_limits<double>::infinity();
    constexpr int steps = 2000;
    for(int i = 0; i < steps; ++i)
      least = (std::min)(least, objective(samples, H, D, i * CGAL_PI / steps));
    EXPECT_LE(objective(samples, H, D, fit.angle(D)), least * (1 + 1e-12)) << trial;
  }
}

TEST(Constrained_direction_fit, GivesSomeAngleWithoutData)
{
  EXPECT_TRUE(std::isfinite(Constrained_direction_fit().angle(0)));
  EXPECT_TRUE(std::isfinite(Constrained_direction_fit().angle(1)));
  EXPECT_TRUE(std::isnan(Constrained_direction_fit().angle(Estimate::nan)));
}
