// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Small meshes with exact curvature, for the tests of the estimators.

#ifndef CGAL_SPIDER_BENCHMARK_TEST_MESHES_H
#define CGAL_SPIDER_BENCHMARK_TEST_MESHES_H

#include "../Estimator.h"

#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace CGAL {
namespace Spider {
namespace benchmark {
namespace test {

inline std::vector<Mesh::Vertex_index> add_points(Mesh& mesh, const std::vector<Point>& points)
{
  std::vector<Mesh::Vertex_index> vertices;
  for(const Point& p : points)
    vertices.push_back(mesh.add_vertex(p));
  return vertices;
}

// An icosahedron, subdivided and projected; 10 * 4^subdivisions + 2 vertices, all but 12 of valence six.
inline Mesh make_sphere(unsigned int subdivisions, double radius = 1)
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point>(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(subdivisions));
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const Vector from_centre = mesh.point(v) - Point(0, 0, 0);
    mesh.point(v) = Point(0, 0, 0) + from_centre * (radius / std::sqrt(from_centre.squared_length()));
  }
  mesh.collect_garbage();
  return mesh;
}

// A triangulated grid of (cells + 1)^2 vertices, row by row; `place` takes both coordinates from [0, 1]. Faces show the
// side from which x runs right and y up.
inline Mesh make_grid(int cells, const std::function<Point(double, double)>& place)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int j = 0; j <= cells; ++j)
    for(int i = 0; i <= cells; ++i)
      v.push_back(mesh.add_vertex(place(double(i) / cells, double(j) / cells)));
  for(int j = 0; j < cells; ++j)
    for(int i = 0; i < cells; ++i)
    {
      const int corner = j * (cells + 1) + i, above = corner + cells + 1;
      mesh.add_face(v[corner], v[corner + 1], v[above + 1]);
      mesh.add_face(v[corner], v[above + 1], v[above]);
    }
  return mesh;
}

// The graph of `height` over [-1, 1]^2; inner vertices are moved by up to `jitter` cells, from a fixed seed.
inline Mesh make_graph(int cells, const std::function<double(double, double)>& height, double jitter = 0)
{
  std::mt19937 random(1);
  const auto shift = [&](double s) {
    const bool inner = s > 0 && s < 1;
    return inner ? s + jitter / cells * (2 * double(random()) / double(std::mt19937::max()) - 1) : s;
  };
  return make_grid(cells, [&](double s, double t) {
    const double x = 2 * shift(s) - 1, y = 2 * shift(t) - 1;
    return Point(x, y, height(x, y));
  });
}

// A part of the unit cylinder around the y axis: 90 degrees wide, as long as that is, seen from outside.
inline Mesh make_cylinder(int cells, double radius = 1)
{
  return make_grid(cells, [&](double s, double t) {
    const double angle = (s - 0.5) * CGAL_PI / 2;
    return Point(radius * std::sin(angle), radius * (t - 0.5) * CGAL_PI / 2, radius * std::cos(angle));
  });
}

// The vertex of a grid that is nearest to the middle.
inline Mesh::Vertex_index middle_vertex(int cells) { return Mesh::Vertex_index((cells / 2) * (cells + 1) + cells / 2); }

// The vertices of a grid that are at least a quarter of its width away from its border.
inline std::vector<Mesh::Vertex_index> inner_vertices(int cells)
{
  std::vector<Mesh::Vertex_index> inner;
  for(int j = cells / 4; j <= cells - cells / 4; ++j)
    for(int i = cells / 4; i <= cells - cells / 4; ++i)
      inner.emplace_back(j * (cells + 1) + i);
  return inner;
}

inline std::vector<Estimate> estimates(const Estimator& estimator, const Mesh& mesh, double radius = 0)
{
  std::vector<Estimate> out;
  estimator.estimate(mesh, radius, out);
  return out;
}

// The mean over `vertices` of |value(estimate) - truth|.
template <typename Vertices, typename Value>
double mean_error(const std::vector<Estimate>& estimates, const Vertices& vertices, double truth, Value value)
{
  double sum = 0;
  std::size_t count = 0;
  for(Mesh::Vertex_index v : vertices)
  {
    sum += std::abs(value(estimates[v.idx()]) - truth);
    ++count;
  }
  return sum / double(count);
}

template <typename Vertices, typename Value>
double worst_error(const std::vector<Estimate>& estimates, const Vertices& vertices, double truth, Value value)
{
  double worst = 0;
  for(Mesh::Vertex_index v : vertices)
  {
    const double error = std::abs(value(estimates[v.idx()]) - truth);
    worst = error <= worst ? worst : error; // so that NaN shows
  }
  return worst;
}

inline double mean(const Estimate& e) { return e.mean_curvature(); }
inline double Gaussian(const Estimate& e) { return e.Gaussian_curvature(); }
inline double least(const Estimate& e) { return e.min_curvature; }
inline double greatest(const Estimate& e) { return e.max_curvature; }

// Radians between two lines.
inline double line_angle(const Vector& a, const Vector& b)
{
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), std::abs(a * b));
}

// The order of convergence that errors at h and h/2 show.
inline double order(double coarse, double fine) { return std::log2(coarse / fine); }

} // namespace test
} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_TEST_MESHES_H
