// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures 3 and 7: the unit cube, whose normals a large radius smooths, and whose feature edges stop that.

#include "../grids.h"
#include "../noise.h"
#include "../tessellations.h"
#include "Figure.h"
#include "figure_estimates.h"

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

constexpr double radius = 0.5; // the paper's, in both figures

Mesh cube(unsigned int cells)
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 1, 1), Point(0, 0, 1),
                        Point(1, 0, 1), Point(1, 1, 1), mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return refine(mesh, cells);
}

bool is_on_side(double x) { return std::abs(x) < 1e-9 || std::abs(x - 1) < 1e-9; }

// how many of the cube's sides a vertex lies on
int number_of_sides(const Point& p) { return is_on_side(p.x()) + is_on_side(p.y()) + is_on_side(p.z()); }

// The place of a vertex on the coarsest of the cubes.
struct Place
{
  std::array<int, 3> cell;
  bool is_exact; // else the coarsest cube has no such vertex
};

Place place_on(const Point& p, int cells)
{
  Place place{{}, true};
  for(int i = 0; i < 3; ++i)
  {
    place.cell[i] = static_cast<int>(std::lround(p[i] * cells));
    place.is_exact = place.is_exact && std::abs(p[i] * cells - place.cell[i]) < 1e-9;
  }
  return place;
}

// turns the diagonals of squares at random, and moves the vertices that the coarsest cube doesn't have by up to a
// quarter of a cell within their sides and edges.
void make_irregular(Mesh& mesh, int cells, int coarsest, Random& random)
{
  const std::vector<Mesh::Edge_index> edges(mesh.edges().begin(), mesh.edges().end());
  for(auto e : edges)
  {
    const auto h = mesh.halfedge(e);
    const Vector along = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
    const int axes = (std::abs(along.x()) > 1e-9) + (std::abs(along.y()) > 1e-9) + (std::abs(along.z()) > 1e-9);
    if(axes == 2 && random.uniform() < 0.5)
      CGAL::Euler::flip_edge(h, mesh);
  }
  for(auto v : mesh.vertices())
  {
    const Point p = mesh.point(v);
    if(place_on(p, coarsest).is_exact)
      continue;
    const auto moved = [&](double x) {
      const double by = random.uniform(-0.25, 0.25) / cells;
      return is_on_side(x) ? x : x + by;
    };
    const double x = moved(p.x()), y = moved(p.y()), z = moved(p.z());
    mesh.point(v) = Point(x, y, z);
  }
}

using Normals_by_place = std::map<std::array<int, 3>, Vector>;

Normals_by_place by_place(const Mesh& mesh, const Curvature_estimates& estimates, int coarsest)
{
  Normals_by_place result;
  for(auto v : mesh.vertices())
    if(const Place place = place_on(mesh.point(v), coarsest); place.is_exact)
      result[place.cell] = estimates[v].normal;
  return result;
}

double mean_angle(const Normals_by_place& a, const Normals_by_place& b)
{
  double sum = 0;
  for(const auto& [place, normal] : a)
    sum += angle(normal, b.at(place));
  return sum / static_cast<double>(a.size());
}

double mean_angle_over_pairs(const std::vector<Normals_by_place>& normals)
{
  double sum = 0;
  int pairs = 0;
  for(std::size_t i = 0; i < normals.size(); ++i)
    for(std::size_t j = i + 1; j < normals.size(); ++j, ++pairs)
      sum += mean_angle(normals[i], normals[j]);
  return sum / pairs;
}

} // namespace

Figure figure_3(const Figure_input&)
{
  constexpr std::array<int, 3> tessellations = {8, 16, 32}; // cells along an edge
  constexpr double of_the_paper = 0.0076;
  Figure figure(3, "Normals of the unit cube, iterated with a radius of 0.5, in three tessellations");
  for(const bool is_irregular : {false, true})
    for(const bool is_published : {true, false})
    {
      std::vector<Normals_by_place> normals_of;
      for(int cells : tessellations)
      {
        Mesh mesh = cube(cells);
        Random random(cells);
        if(is_irregular)
          make_irregular(mesh, cells, tessellations.front(), random);
        const auto estimates = is_published ? estimate_as_published(mesh, radius) : estimate(mesh, radius);
        normals_of.push_back(by_place(mesh, estimates, tessellations.front()));
        if(is_irregular && is_published)
        {
          const std::string name = std::to_string(cells);
          figure.add_mesh(name, mesh);
          figure.add_panel(std::to_string(mesh.number_of_faces()) + " triangles", name);
          figure.add_vectors(normals(estimates));
        }
      }
      const double difference = mean_angle_over_pairs(normals_of);
      const std::string about = std::string("mean difference between corresponding normals, ") +
                                (is_irregular ? "irregular" : "regular") + " tessellations, " +
                                (is_published ? "section_fit as published" : "surface_fit, the default");
      figure.add_claim(about, digits(of_the_paper) + " rad",
                       digits(difference) + " rad, " + digits(difference / of_the_paper) + " times as much",
                       difference <= of_the_paper);
    }
  return figure;
}

Figure figure_7(const Figure_input&)
{
  constexpr int cells = 20;
  constexpr double amplitude = 0.5; // [-a/4, a/4]
  Mesh mesh = cube(cells);
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  std::vector<Vector> truth(mesh.num_vertices()); // of those that lie on one side
  std::vector<Mesh::Vertex_index> on_sides;
  for(auto v : mesh.vertices())
  {
    const Point p = mesh.point(v);
    const auto outwards = [](double x) { return is_on_side(x) ? (x < 0.5 ? -1. : 1.) : 0.; };
    truth[v] = Vector(outwards(p.x()), outwards(p.y()), outwards(p.z()));
    if(number_of_sides(p) == 1)
      on_sides.push_back(v);
  }
  for(auto e : mesh.edges())
  {
    const Point middle = CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
    is_feature[e] = number_of_sides(middle) == 2;
  }
  Random random(1);
  add_noise(mesh, area_weighted_normals(mesh), mean_edge_length(mesh), {amplitude}, random);

  Figure figure(7, "The noisy unit cube, isotropic and anisotropic");
  figure.add_mesh("mesh", mesh);
  std::array<double, 2> normal_errors, curvature_errors;
  const std::array<Curvature_estimates, 2> estimates = {estimate(mesh, radius), estimate(mesh, radius, is_feature)};
  for(int i : {0, 1})
  {
    figure.add_panel(i == 0 ? "normals, isotropic" : "normals, anisotropic", "mesh");
    figure.add_vectors(normals(estimates[i]));
    normal_errors[i] = curvature_errors[i] = 0;
    for(auto v : on_sides)
    {
      normal_errors[i] += angle(estimates[i][v].normal, truth[v]) / static_cast<double>(on_sides.size());
      curvature_errors[i] += std::abs(estimates[i][v].mean_curvature()) / static_cast<double>(on_sides.size());
    }
  }
  for(int i : {0, 1})
  {
    figure.add_panel(i == 0 ? "H, isotropic" : "H, anisotropic", "mesh");
    figure.add_field("H", mean_curvatures(estimates[i]));
  }
  const auto pair = [](const std::array<double, 2>& errors, const std::string& unit) {
    return digits(errors[0]) + unit + " isotropic, " + digits(errors[1]) + unit + " anisotropic, a share of 1 / " +
           digits(errors[0] / errors[1]);
  };
  figure.add_claim("mean error of normals on the sides", "anisotropic is better", pair(normal_errors, " rad"),
                   normal_errors[1] < normal_errors[0]);
  figure.add_claim("mean error of H on the sides, where it is 0", "anisotropic is better", pair(curvature_errors, ""),
                   curvature_errors[1] < curvature_errors[0]);
  return figure;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
