// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "grids.h"

#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace benchmark {

Mesh make_grid(const std::pair<Axis, Axis>& axes, const std::function<Point(double, double)>& position)
{
  const auto& [s, t] = axes;
  const std::size_t s_cells = s.closed ? s.count : s.count - 1;
  const std::size_t t_cells = t.closed ? t.count : t.count - 1;

  Mesh mesh;
  mesh.reserve(s.count * t.count, 3 * s.count * t.count, 2 * s_cells * t_cells);
  for(std::size_t j = 0; j < t.count; ++j)
    for(std::size_t i = 0; i < s.count; ++i)
      mesh.add_vertex(position(static_cast<double>(i) / static_cast<double>(s_cells),
                               static_cast<double>(j) / static_cast<double>(t_cells)));

  const auto vertex = [columns = s.count, rows = t.count](std::size_t i, std::size_t j) {
    return Mesh::Vertex_index(static_cast<Mesh::size_type>((j % rows) * columns + i % columns));
  };
  for(std::size_t j = 0; j < t_cells; ++j)
    for(std::size_t i = 0; i < s_cells; ++i)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

namespace {

// The vertices of a refined mesh: those of the old one, then those within edges, then those within faces.
class Refinement
{
public:
  Refinement(const Mesh& mesh, unsigned int pieces)
    : mesh(mesh), pieces(pieces), edges_begin(mesh.num_vertices()),
      faces_begin(edges_begin + mesh.num_edges() * (pieces - 1))
  {
    const std::size_t faces = mesh.num_faces() * pieces * pieces;
    const std::size_t vertices = faces_begin + mesh.num_faces() * (pieces - 1) * (pieces - 2) / 2;
    refined.reserve(static_cast<Mesh::size_type>(vertices), static_cast<Mesh::size_type>(faces * 3 / 2 + pieces),
                    static_cast<Mesh::size_type>(faces));
    for(std::size_t v = 0; v < vertices; ++v)
      refined.add_vertex();
  }

  Mesh operator()()
  {
    for(auto face : mesh.faces())
    {
      place_vertices(face);
      for(unsigned int row = 0; row < pieces; ++row)
        for(unsigned int i = 0; i + row < pieces; ++i)
        {
          refined.add_face(vertex(face, i, row), vertex(face, i + 1, row), vertex(face, i, row + 1));
          if(i + row + 1 < pieces)
            refined.add_face(vertex(face, i + 1, row), vertex(face, i + 1, row + 1), vertex(face, i, row + 1));
        }
    }
    return std::move(refined);
  }

private:
  // In a face with halfedges h0, h1, h2, vertex (i, row) is i steps along h0 and row steps towards h0's opposite
  // corner.
  Mesh::Vertex_index vertex(Mesh::Face_index face, unsigned int i, unsigned int row) const
  {
    const auto h0 = mesh.halfedge(face);
    const unsigned int rest = pieces - i - row;
    if(row == 0)
      return on_halfedge(h0, i);
    if(rest == 0)
      return on_halfedge(mesh.next(h0), row);
    if(i == 0)
      return on_halfedge(mesh.prev(h0), pieces - row);
    // rows 1, 2, ... hold pieces - 2, pieces - 3, ... inner vertices
    const std::size_t before = std::size_t(row - 1) * (pieces - 2) - std::size_t(row - 1) * (row - 2) / 2;
    const std::size_t per_face = std::size_t(pieces - 1) * (pieces - 2) / 2;
    return index(faces_begin + std::size_t(face) * per_face + before + (i - 1));
  }

  Mesh::Vertex_index on_halfedge(Mesh::Halfedge_index h, unsigned int step) const
  {
    if(step == 0)
      return mesh.source(h);
    if(step == pieces)
      return mesh.target(h);
    const auto edge = mesh.edge(h);
    const unsigned int along = h == mesh.halfedge(edge, 0) ? step : pieces - step;
    return index(edges_begin + std::size_t(edge) * (pieces - 1) + (along - 1));
  }

  void place_vertices(Mesh::Face_index face)
  {
    const auto h0 = mesh.halfedge(face);
    const Point origin = mesh.point(mesh.source(h0));
    const Vector along = mesh.point(mesh.target(h0)) - origin;
    const Vector up = mesh.point(mesh.target(mesh.next(h0))) - origin;
    for(unsigned int row = 0; row <= pieces; ++row)
      for(unsigned int i = 0; i + row <= pieces; ++i)
        refined.point(vertex(face, i, row)) = origin + (double(i) / pieces) * along + (double(row) / pieces) * up;
  }

  static Mesh::Vertex_index index(std::size_t i) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(i)); }

  const Mesh& mesh;
  const unsigned int pieces;
  const std::size_t edges_begin, faces_begin;
  Mesh refined;
};

} // namespace

Mesh refine(const Mesh& mesh, unsigned int pieces) { return pieces == 1 ? mesh : Refinement(mesh, pieces)(); }

Mesh make_icosphere(std::size_t number_of_vertices)
{
  Mesh icosahedron;
  CGAL::make_icosahedron(icosahedron, Point(0, 0, 0));
  const double pieces = std::round(std::sqrt(static_cast<double>(number_of_vertices) / 10));
  Mesh mesh = refine(icosahedron, static_cast<unsigned int>(std::max(1., pieces)));
  for(auto v : mesh.vertices())
  {
    const Vector position = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + position / std::sqrt(position.squared_length());
  }
  return mesh;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
