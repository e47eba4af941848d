// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of analytic shapes for the tests, of any type: `meshes::icosphere<Mesh>(3)`. All point outwards, or upwards.

#ifndef CGAL_SPIDER_TEST_MESHES_H
#define CGAL_SPIDER_TEST_MESHES_H

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace meshes {

using Vector = Eigen::Vector3d;
using Triangle = std::array<std::size_t, 3>;

inline const double pi = std::acos(-1.);

template <typename Mesh>
using Point_of =
  typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;

/// returns a point or vector of any kernel as one of Eigen's.
template <typename Triple>
Vector vector(const Triple& a)
{
  return {CGAL::to_double(a.x()), CGAL::to_double(a.y()), CGAL::to_double(a.z())};
}

template <typename Mesh, typename Vertex>
Vector point(const Mesh& mesh, Vertex v)
{
  return vector(get(get(CGAL::vertex_point, mesh), v));
}

template <typename Mesh>
Mesh from_soup(const std::vector<Vector>& points, const std::vector<Triangle>& triangles)
{
  std::vector<Point_of<Mesh>> mesh_points;
  for(const Vector& p : points)
    mesh_points.emplace_back(p.x(), p.y(), p.z());
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(mesh_points, triangles, mesh);
  return mesh;
}

/// moves every vertex from its point p to `where(p)`.
template <typename Mesh, typename Where>
Mesh moved(Mesh mesh, Where&& where)
{
  auto points = get(CGAL::vertex_point, mesh);
  for(auto v : vertices(mesh))
  {
    const Vector p = where(vector(get(points, v)));
    put(points, v, Point_of<Mesh>(p.x(), p.y(), p.z()));
  }
  return mesh;
}

/// moves every vertex by a random vector with coordinates in [-amplitude, amplitude].
template <typename Mesh>
Mesh jittered(Mesh mesh, double amplitude, unsigned seed)
{
  std::mt19937 random(seed);
  // A distribution of the standard library would give other numbers with another library.
  const auto next = [&] { return amplitude * (2 * (random() / 4294967295.) - 1); };
  return moved(std::move(mesh), [&](const Vector& p) {
    const double x = next(), y = next(), z = next();
    return Vector(p + Vector(x, y, z));
  });
}

/// How the quadrilaterals of a patch are split into triangles.
enum Diagonals
{
  forward,
  backward,
  alternating
};

/// returns the patch of `where(i, j)`, for i from 0 to nu and j from 0 to nv; round where it wraps.
template <typename Mesh, typename Where>
Mesh patch(int nu, int nv, Where&& where, Diagonals diagonals = forward, bool wraps_u = false, bool wraps_v = false)
{
  const int rows = wraps_u ? nu : nu + 1, columns = wraps_v ? nv : nv + 1;
  std::vector<Vector> points;
  for(int i = 0; i < rows; ++i)
    for(int j = 0; j < columns; ++j)
      points.push_back(where(i, j));
  const auto at = [&](int i, int j) { return std::size_t(i % rows) * columns + j % columns; };
  std::vector<Triangle> triangles;
  for(int i = 0; i < nu; ++i)
    for(int j = 0; j < nv; ++j)
    {
      const std::size_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if(diagonals == forward || (diagonals == alternating && (i + j) % 2 == 0))
        triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
      else
        triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
    }
  return from_soup<Mesh>(points, triangles);
}

/// returns the graph of `height(x, y)` over the square [-n, n]² times `spacing`; vertex (i, j) has the number
/// (2n + 1) (i + n) + j + n.
template <typename Mesh, typename Height>
Mesh height_field(int n, double spacing, Height&& height, Diagonals diagonals = forward)
{
  return patch<Mesh>(
    2 * n, 2 * n,
    [&](int i, int j) {
      const double x = (i - n) * spacing, y = (j - n) * spacing;
      return Vector(x, y, height(x, y));
    },
    diagonals);
}

template <typename Mesh>
Mesh plane(int n, double spacing = 1, Diagonals diagonals = forward)
{
  return height_field<Mesh>(
    n, spacing, [](double, double) { return 0.; }, diagonals);
}

/// returns the graph of z = (a x² + b y²) / 2.
template <typename Mesh>
Mesh saddle(int n, double spacing, double a = 1, double b = -1, Diagonals diagonals = forward)
{
  return height_field<Mesh>(
    n, spacing, [=](double x, double y) { return (a * x * x + b * y * y) / 2; }, diagonals);
}

/// returns an open cylinder around the z axis, from z = 0 to `height`.
template <typename Mesh>
Mesh cylinder(double radius, double height, int around, int along, Diagonals diagonals = forward)
{
  return patch<Mesh>(
    around, along,
    [=](int i, int j) {
      const double angle = 2 * pi * i / around;
      return Vector(radius * std::cos(angle), radius * std::sin(angle), height * j / along);
    },
    diagonals, true);
}

template <typename Mesh>
Mesh torus(double radius, double tube_radius, int around, int around_tube, Diagonals diagonals = forward)
{
  return patch<Mesh>(
    around, around_tube,
    [=](int i, int j) {
      const double u = 2 * pi * i / around, v = 2 * pi * j / around_tube;
      const double distance = radius + tube_radius * std::cos(v);
      return Vector(distance * std::cos(u), distance * std::sin(u), tube_radius * std::sin(v));
    },
    diagonals, true, true);
}

/// returns an icosahedron whose faces have been split into 4 `level` times; its vertices lie on the sphere.
template <typename Mesh>
Mesh icosphere(int level, double radius = 1)
{
  const double g = (1 + std::sqrt(5.)) / 2;
  std::vector<Vector> points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<Triangle> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for(int i = 0; i < level; ++i)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
    const auto midpoint = [&](std::size_t a, std::size_t b) {
      const auto [found, is_new] = midpoints.insert({std::minmax(a, b), points.size()});
      if(is_new)
        points.push_back((points[a].normalized() + points[b].normalized()) / 2);
      return found->second;
    };
    std::vector<Triangle> split;
    for(const auto& [a, b, c] : triangles)
    {
      const std::size_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      split.insert(split.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = split;
  }
  for(Vector& p : points)
    p *= radius / p.norm();
  return from_soup<Mesh>(points, triangles);
}

/// returns the cube [0, 1]³ with n × n squares on each side.
template <typename Mesh>
Mesh cube(int n, Diagonals diagonals = forward)
{
  std::map<std::array<int, 3>, std::size_t> numbers;
  std::vector<Vector> points;
  const auto number = [&](const std::array<int, 3>& p) {
    const auto [found, is_new] = numbers.insert({p, points.size()});
    if(is_new)
      points.push_back(Vector(p[0], p[1], p[2]) / n);
    return found->second;
  };
  std::vector<Triangle> triangles;
  for(int axis = 0; axis < 3; ++axis)
    for(int side : {0, n})
      for(int i = 0; i < n; ++i)
        for(int j = 0; j < n; ++j)
        {
          const auto at = [&](int u, int v) {
            std::array<int, 3> p;
            p[axis] = side;
            p[(axis + 1) % 3] = side == 0 ? v : u; // so that all sides face outwards
            p[(axis + 2) % 3] = side == 0 ? u : v;
            return number(p);
          };
          const std::size_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
          if(diagonals == forward || (diagonals == alternating && (i + j) % 2 == 0))
            triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
          else
            triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
        }
  return from_soup<Mesh>(points, triangles);
}

/// returns the mean length of the edges.
template <typename Mesh>
double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(auto e : edges(mesh))
    sum += (point(mesh, source(halfedge(e, mesh), mesh)) - point(mesh, target(halfedge(e, mesh), mesh))).norm();
  return sum / double(edges(mesh).size());
}

#ifdef SPIDER_DATA_DIR
/// reads one of CGAL's meshes and triangulates it; returns whether there is such a file and it is a mesh.
template <typename Mesh>
bool read(const std::string& name, Mesh& mesh)
{
  const std::string file = std::string(SPIDER_DATA_DIR) + "/" + name;
  return std::filesystem::exists(file) && CGAL::IO::read_polygon_mesh(file, mesh) &&
         CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
}
#endif

} // namespace meshes

#endif // CGAL_SPIDER_TEST_MESHES_H
