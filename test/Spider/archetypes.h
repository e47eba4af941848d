// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The least that models of the concepts which Spider names have: what compiles with these asks for no more.

#ifndef CGAL_SPIDER_TEST_ARCHETYPES_H
#define CGAL_SPIDER_TEST_ARCHETYPES_H

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace archetypes {

/// A kernel: numbers, points and vectors. Points can be compared, and made from points and vectors.
struct Kernel
{
  using FT = double;

  struct Triple
  {
    using R = Kernel;
    Triple() = default;
    Triple(FT x, FT y, FT z) : coordinates{x, y, z} {}
    FT x() const { return coordinates[0]; }
    FT y() const { return coordinates[1]; }
    FT z() const { return coordinates[2]; }
    std::array<FT, 3> coordinates;
  };
  struct Vector_3 : Triple
  {
    using Triple::Triple;
    friend Vector_3 operator*(FT s, const Vector_3& a) { return {s * a.x(), s * a.y(), s * a.z()}; }
  };
  struct Point_3 : Triple
  {
    using Triple::Triple;
    friend bool operator==(const Point_3& a, const Point_3& b) { return a.coordinates == b.coordinates; }
    friend Vector_3 operator-(const Point_3& a, const Point_3& b)
    {
      return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
    }
    friend Point_3 operator+(const Point_3& a, const Vector_3& b)
    {
      return {a.x() + b.x(), a.y() + b.y(), a.z() + b.z()};
    }
  };
};

/// A descriptor: regular, ordered and hashable, as the graph concepts have it, and neither a number nor a pointer.
template <typename Kind>
struct Descriptor
{
  Descriptor() = default;
  explicit Descriptor(std::ptrdiff_t n) : number(n) {}
  friend bool operator==(const Descriptor& a, const Descriptor& b) { return a.number == b.number; }
  friend bool operator!=(const Descriptor& a, const Descriptor& b) { return a.number != b.number; }
  friend bool operator<(const Descriptor& a, const Descriptor& b) { return a.number < b.number; }

  std::ptrdiff_t number = -1; ///< for the graph alone
};

template <typename Kind>
std::size_t at(const Descriptor<Kind>& d)
{
  return static_cast<std::size_t>(d.number);
}

/// A model of `FaceListGraph`, `HalfedgeListGraph`, `VertexListGraph` and `EdgeListGraph`.
class Graph
{
public:
  using Vertex = Descriptor<struct Vertex_kind>;
  using Halfedge = Descriptor<struct Halfedge_kind>;
  using Edge = Descriptor<struct Edge_kind>;
  using Face = Descriptor<struct Face_kind>;
  template <typename Item>
  using Range = CGAL::Iterator_range<typename std::vector<Item>::const_iterator>;

  /// takes a mesh whose opposite halfedges have numbers that follow one another.
  template <typename Surface_mesh>
  explicit Graph(const Surface_mesh& mesh)
  {
    for(auto v : mesh.vertices())
    {
      vertices_.push_back(Vertex(v));
      halfedge_of_vertex_.push_back(Halfedge(mesh.halfedge(v)));
      points_.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    }
    for(auto h : mesh.halfedges())
    {
      halfedges_.push_back(Halfedge(h));
      target_.push_back(Vertex(mesh.target(h)));
      next_.push_back(Halfedge(mesh.next(h)));
      prev_.push_back(Halfedge(mesh.prev(h)));
      face_.push_back(mesh.is_border(h) ? Face() : Face(mesh.face(h)));
    }
    for(auto e : mesh.edges())
      edges_.push_back(Edge(e));
    for(auto f : mesh.faces())
    {
      faces_.push_back(Face(f));
      halfedge_of_face_.push_back(Halfedge(mesh.halfedge(f)));
    }
  }
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;

  friend Vertex target(Halfedge h, const Graph& g) { return g.target_[at(h)]; }
  friend Vertex source(Halfedge h, const Graph& g) { return target(opposite(h, g), g); }
  friend Halfedge next(Halfedge h, const Graph& g) { return g.next_[at(h)]; }
  friend Halfedge prev(Halfedge h, const Graph& g) { return g.prev_[at(h)]; }
  friend Halfedge opposite(Halfedge h, const Graph&) { return Halfedge(h.number ^ 1); }
  friend Face face(Halfedge h, const Graph& g) { return g.face_[at(h)]; }
  friend Edge edge(Halfedge h, const Graph&) { return Edge(h.number / 2); }
  friend Halfedge halfedge(Edge e, const Graph&) { return Halfedge(2 * e.number); }
  friend Halfedge halfedge(Vertex v, const Graph& g) { return g.halfedge_of_vertex_[at(v)]; }
  friend Halfedge halfedge(Face f, const Graph& g) { return g.halfedge_of_face_[at(f)]; }
  friend Range<Vertex> vertices(const Graph& g) { return {g.vertices_.begin(), g.vertices_.end()}; }
  friend Range<Halfedge> halfedges(const Graph& g) { return {g.halfedges_.begin(), g.halfedges_.end()}; }
  friend Range<Edge> edges(const Graph& g) { return {g.edges_.begin(), g.edges_.end()}; }
  friend Range<Face> faces(const Graph& g) { return {g.faces_.begin(), g.faces_.end()}; }

  /// What `get(CGAL::vertex_point, graph)` returns.
  class Points
  {
  public:
    using key_type = Vertex;
    using value_type = Kernel::Point_3;
    using reference = Kernel::Point_3;
    using category = boost::read_write_property_map_tag;
    explicit Points(const Graph& graph) : points_(const_cast<Graph&>(graph).points_.data()) {}
    friend Kernel::Point_3 get(const Points& map, Vertex v) { return map.points_[at(v)]; }
    friend void put(const Points& map, Vertex v, const Kernel::Point_3& p) { map.points_[at(v)] = p; }

  private:
    Kernel::Point_3* points_;
  };
  friend Points get(CGAL::vertex_point_t, const Graph& g) { return Points(g); }

private:
  std::vector<Vertex> vertices_, target_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_, face_;
  std::vector<Halfedge> halfedges_, next_, prev_, halfedge_of_vertex_, halfedge_of_face_;
  std::vector<Kernel::Point_3> points_;
};

/// A property map that can only be read.
template <typename Key, typename Value>
class Readable_map
{
public:
  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;
  explicit Readable_map(std::function<Value(const Key&)> value) : value_(std::move(value)) {}
  friend Value get(const Readable_map& map, const Key& key) { return map.value_(key); }

private:
  std::function<Value(const Key&)> value_;
};

/// A property map that can only be written.
template <typename Key, typename Value>
class Writable_map
{
public:
  using key_type = Key;
  using value_type = Value;
  using reference = void;
  using category = boost::writable_property_map_tag;
  explicit Writable_map(std::map<Key, Value>& values) : values_(&values) {}
  friend void put(const Writable_map& map, const Key& key, const Value& value) { (*map.values_)[key] = value; }

private:
  std::map<Key, Value>* values_;
};

} // namespace archetypes

template <typename Kind>
struct std::hash<archetypes::Descriptor<Kind>>
{
  std::size_t operator()(const archetypes::Descriptor<Kind>& d) const { return archetypes::at(d); }
};

namespace boost {

template <>
struct graph_traits<archetypes::Graph>
{
  using Graph = archetypes::Graph;
  using vertex_descriptor = Graph::Vertex;
  using halfedge_descriptor = Graph::Halfedge;
  using edge_descriptor = Graph::Edge;
  using face_descriptor = Graph::Face;
  using vertex_iterator = std::vector<vertex_descriptor>::const_iterator;
  using halfedge_iterator = std::vector<halfedge_descriptor>::const_iterator;
  using edge_iterator = std::vector<edge_descriptor>::const_iterator;
  using face_iterator = std::vector<face_descriptor>::const_iterator;
  using directed_category = undirected_tag;
  using edge_parallel_category = disallow_parallel_edge_tag;
  using traversal_category = edge_list_graph_tag;
  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using degree_size_type = std::size_t;
  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

template <>
struct property_map<archetypes::Graph, CGAL::vertex_point_t>
{
  using type = archetypes::Graph::Points;
  using const_type = archetypes::Graph::Points;
};

} // namespace boost

namespace CGAL {

template <>
struct graph_has_property<archetypes::Graph, vertex_point_t> : Tag_true
{};

} // namespace CGAL

#endif // CGAL_SPIDER_TEST_ARCHETYPES_H
