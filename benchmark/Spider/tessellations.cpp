// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tessellations.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

double length(const Vector& v) { return std::sqrt(v.squared_length()); }

// Twice the area of a triangle as seen along a unit normal, in units of its longest edge's square: an equilateral one
// that faces the normal has 0.87, a folded one is negative.
double fatness(const Point& p, const Point& q, const Point& r, const Vector& normal)
{
  const double longest =
    std::max({CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)});
  return CGAL::cross_product(q - p, r - p) * normal / longest;
}

// The two faces beside an edge and the two that a flip would put in their place.
class Flip
{
public:
  Flip(const Mesh& mesh, Mesh::Edge_index edge) : mesh(mesh), h(mesh.halfedge(edge)) {}

  Mesh::Vertex_index source() const { return mesh.source(h); }
  Mesh::Vertex_index target() const { return mesh.target(h); }
  Mesh::Vertex_index left() const { return mesh.target(mesh.next(h)); }
  Mesh::Vertex_index right() const { return mesh.target(mesh.next(mesh.opposite(h))); }

  // whether the flipped mesh is still one, and its new faces face the normals and are thicker than a hair
  bool is_allowed(const std::vector<Vector>& normals) const
  {
    constexpr double thinnest = 0.005;
    if(mesh.is_border(mesh.edge(h)) || mesh.degree(source()) <= 3 || mesh.degree(target()) <= 3 || left() == right() ||
       mesh.halfedge(left(), right()) != Mesh::null_halfedge())
      return false;
    const Point s = mesh.point(source()), t = mesh.point(target()), l = mesh.point(left()), r = mesh.point(right());
    const Vector sum = normals[source()] + normals[target()] + normals[left()] + normals[right()];
    const Vector normal = sum / length(sum);
    return fatness(s, r, l, normal) > thinnest && fatness(t, l, r, normal) > thinnest;
  }

  // whether the angles opposite to the edge add up to more than pi
  bool is_towards_Delaunay() const
  {
    constexpr double rounding = 1e-9; // flips of cocircular points would never end
    return cotangent(left()) + cotangent(right()) < -rounding;
  }

  std::array<Mesh::Edge_index, 4> rim() const
  {
    const auto g = mesh.opposite(h);
    return {mesh.edge(mesh.next(h)), mesh.edge(mesh.prev(h)), mesh.edge(mesh.next(g)), mesh.edge(mesh.prev(g))};
  }

private:
  double cotangent(Mesh::Vertex_index opposite) const
  {
    const Vector a = mesh.point(source()) - mesh.point(opposite), b = mesh.point(target()) - mesh.point(opposite);
    return a * b / length(CGAL::cross_product(a, b));
  }

  const Mesh& mesh;
  Mesh::Halfedge_index h;
};

std::vector<Vector> exact_normals(const Mesh& mesh, const Shape& shape)
{
  std::vector<Vector> normals;
  normals.reserve(mesh.num_vertices());
  for(auto v : mesh.vertices())
    normals.push_back(shape.truth(mesh.point(v)).normal);
  return normals;
}

// whether no face at a vertex would be folded or thinner than `thinnest`, were the vertex at `position`
bool is_fair_move(const Mesh& mesh, Mesh::Vertex_index v, const Point& position, const Vector& normal, double thinnest)
{
  for(auto h : CGAL::halfedges_around_target(v, mesh))
    if(!mesh.is_border(h) &&
       fatness(mesh.point(mesh.source(h)), position, mesh.point(mesh.target(mesh.next(h))), normal) < thinnest)
      return false;
  return true;
}

// Moves inner vertices about on the shape, each up to half-way into one of its faces, unless faces become too thin.
void scatter(Mesh& mesh, const Shape& shape, std::vector<Vector>& normals, double thinnest, Random& random)
{
  constexpr double farthest = 0.5;
  for(auto v : mesh.vertices())
  {
    const double which = random.uniform(), first = random.uniform(), second = random.uniform();
    if(mesh.is_border(v))
      continue;
    auto h = mesh.halfedge(v);
    for(auto turns = static_cast<int>(which * mesh.degree(v)); turns > 0; --turns)
      h = mesh.next_around_target(h);
    const Point here = mesh.point(v);
    const Vector step =
      first * (mesh.point(mesh.source(h)) - here) + second * (mesh.point(mesh.target(mesh.next(h))) - here);
    const Point moved = shape.project(here + farthest * step);
    if(!is_fair_move(mesh, v, moved, normals[v], thinnest))
      continue;
    mesh.point(v) = moved;
    normals[v] = shape.truth(moved).normal;
  }
}

Mesh regular(const Shape& shape, std::size_t number_of_vertices)
{
  return shape.tessellate(number_of_vertices, {[](double t) { return t; }});
}

Mesh irregular(const Shape& shape, std::size_t number_of_vertices, Random& random)
{
  constexpr int rounds = 4;        // 30 % of vertices then have valence six, 28.5 % after ten rounds
  constexpr double thinnest = 0.1; // about six degrees
  Mesh mesh = regular(shape, number_of_vertices);
  std::vector<Vector> normals = exact_normals(mesh, shape);
  for(int round = 0; round < rounds; ++round)
  {
    scatter(mesh, shape, normals, thinnest, random);
    flip_to_Delaunay(mesh, normals);
  }
  return mesh;
}

// Rows at random distances that vary 20-fold from one to the next, evenly on a logarithmic scale.
constexpr double spacing_ratio = 20;

std::function<double(double)> uneven_rows(std::size_t count, Random& random)
{
  std::vector<double> knots = {0};
  for(std::size_t i = 0; i < count; ++i)
    knots.push_back(knots.back() + std::pow(spacing_ratio, random.uniform()));
  return [knots = std::move(knots)](double t) {
    const double row = t * static_cast<double>(knots.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(row), knots.size() - 2);
    return (knots[below] + (row - static_cast<double>(below)) * (knots[below + 1] - knots[below])) / knots.back();
  };
}

// Large faces beside small ones, and slivers: the widest rows make square cells, the narrowest cells of 1 to 20.
Mesh sliver_ridden(const Shape& shape, std::size_t number_of_vertices, Random& random)
{
  constexpr double flipped_share = 0.1;
  constexpr double thinnest = 0.01;
  const double crowding = spacing_ratio * std::log(spacing_ratio) / (spacing_ratio - 1); // widest over mean spacing
  const double rows = std::sqrt(static_cast<double>(number_of_vertices) * crowding);
  Mesh mesh = shape.tessellate(number_of_vertices, {uneven_rows(static_cast<std::size_t>(rows), random), crowding});
  std::vector<Vector> normals = exact_normals(mesh, shape);
  scatter(mesh, shape, normals, thinnest, random);
  flip_at_random(mesh, normals, flipped_share, random);
  return mesh;
}

using Names = std::vector<std::pair<std::string, Tessellation>>;

const Names& names()
{
  static const Names all = {
    {"regular", Tessellation::regular}, {"irregular", Tessellation::irregular}, {"slivers", Tessellation::slivers}};
  return all;
}

} // namespace

void flip_to_Delaunay(Mesh& mesh, const std::vector<Vector>& normals)
{
  std::vector<Mesh::Edge_index> pending(mesh.edges().begin(), mesh.edges().end());
  std::vector<char> is_pending(mesh.num_edges(), true);
  while(!pending.empty())
  {
    const auto edge = pending.back();
    pending.pop_back();
    is_pending[edge] = false;
    const Flip flip(mesh, edge);
    if(mesh.is_border(edge) || !flip.is_towards_Delaunay() || !flip.is_allowed(normals))
      continue;
    for(auto other : flip.rim())
      if(!std::exchange(is_pending[other], true))
        pending.push_back(other);
    CGAL::Euler::flip_edge(mesh.halfedge(edge), mesh);
  }
}

void flip_at_random(Mesh& mesh, const std::vector<Vector>& normals, double share, Random& random)
{
  for(auto edge : mesh.edges())
    if(random.uniform() < share && Flip(mesh, edge).is_allowed(normals))
      CGAL::Euler::flip_edge(mesh.halfedge(edge), mesh);
}

std::vector<Vector> area_weighted_normals(const Mesh& mesh)
{
  std::vector<Vector> normals(mesh.num_vertices(), Vector(0, 0, 0));
  for(auto face : mesh.faces())
  {
    std::array<Mesh::Vertex_index, 3> corner;
    std::copy_n(CGAL::vertices_around_face(mesh.halfedge(face), mesh).begin(), 3, corner.begin());
    const Point& origin = mesh.point(corner[0]);
    const Vector area = CGAL::cross_product(mesh.point(corner[1]) - origin, mesh.point(corner[2]) - origin);
    for(auto v : corner)
      normals[v] += area;
  }
  for(Vector& normal : normals)
    if(normal.squared_length() > 0)
      normal /= length(normal);
  return normals;
}

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(auto edge : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(edge, 0)), mesh.point(mesh.vertex(edge, 1))));
  return sum / static_cast<double>(mesh.number_of_edges());
}

std::vector<std::string> tessellation_names()
{
  std::vector<std::string> result;
  for(const auto& name : names())
    result.push_back(name.first);
  return result;
}

Tessellation tessellation_of(const std::string& name)
{
  for(const auto& known : names())
    if(known.first == name)
      return known.second;
  throw std::invalid_argument("no tessellation is called \"" + name + "\"; there are: regular irregular slivers");
}

Mesh tessellate(const Shape& shape, Tessellation tessellation, std::size_t number_of_vertices, Random& random)
{
  switch(tessellation)
  {
    case Tessellation::irregular: return irregular(shape, number_of_vertices, random);
    case Tessellation::slivers: return sliver_ridden(shape, number_of_vertices, random);
    default: return regular(shape, number_of_vertices);
  }
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
