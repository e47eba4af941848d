// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_SHARED_VERTEX_GATHERER_H
#define CGAL_SPIDER_BENCHMARK_SHARED_VERTEX_GATHERER_H

#include "../../Estimator.h"

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Spider {
namespace benchmark {

// Gathers the vertices around a vertex, the vertex itself first, breadth-first over edges. Which vertices a search has
// met is told by a stamp per vertex, so that a search costs what it finds.
class Vertex_gatherer
{
public:
  using Vertices = std::vector<Mesh::Vertex_index>;

  explicit Vertex_gatherer(const Mesh& mesh) : m_mesh(mesh), m_stamps(mesh.num_vertices(), 0) {}

  // The fewest whole rings that hold `fewest` vertices, the centre included; fewer where the component has no more.
  const Vertices& rings(Mesh::Vertex_index centre, std::size_t fewest)
  {
    start(centre);
    for(std::size_t ring = 0; m_gathered.size() < fewest && ring < m_gathered.size();)
      for(const std::size_t end = m_gathered.size(); ring < end; ++ring)
        for_each_neighbour(m_gathered[ring], [this](Mesh::Vertex_index w) { gather(w); });
    return m_gathered;
  }

  // All vertices within `radius` that are connected to the centre by edges between such vertices. Where they are fewer
  // than `fewest` the radius grows until they suffice or the component has no more.
  const Vertices& ball(Mesh::Vertex_index centre, double radius, std::size_t fewest)
  {
    constexpr double growth = 1.44; // of the squared radius: 1.2 times the radius, so about half as many vertices more
    double squared_radius = radius * radius;
    for(;;)
    {
      const double nearest_outside = gather_ball(centre, squared_radius);
      if(m_gathered.size() >= fewest || !std::isfinite(nearest_outside))
        return m_gathered;
      squared_radius = (std::max)(growth * squared_radius, nearest_outside);
    }
  }

private:
  void start(Mesh::Vertex_index centre)
  {
    ++m_stamp;
    m_gathered.clear();
    gather(centre);
  }

  void gather(Mesh::Vertex_index v)
  {
    if(m_stamps[v.idx()] == m_stamp)
      return;
    m_stamps[v.idx()] = m_stamp;
    m_gathered.push_back(v);
  }

  // returns the least squared distance of a neighbour that was left outside, infinity if there is none
  double gather_ball(Mesh::Vertex_index centre, double squared_radius)
  {
    double nearest_outside = std::numeric_limits<double>::infinity();
    start(centre);
    const Point& origin = m_mesh.point(centre);
    for(std::size_t i = 0; i < m_gathered.size(); ++i)
      for_each_neighbour(m_gathered[i], [&](Mesh::Vertex_index w) {
        if(m_stamps[w.idx()] == m_stamp)
          return;
        const double squared_distance = (m_mesh.point(w) - origin).squared_length();
        if(squared_distance <= squared_radius)
          gather(w);
        else
          nearest_outside = (std::min)(nearest_outside, squared_distance);
      });
    return nearest_outside;
  }

  template <typename Function>
  void for_each_neighbour(Mesh::Vertex_index v, Function function)
  {
    const Mesh::Halfedge_index first = m_mesh.halfedge(v);
    if(first == Mesh::null_halfedge())
      return;
    Mesh::Halfedge_index h = first;
    do
    {
      function(m_mesh.source(h));
      h = m_mesh.next_around_target(h);
    } while(h != first);
  }

  const Mesh& m_mesh;
  std::vector<std::uint32_t> m_stamps;
  std::uint32_t m_stamp = 0;
  Vertices m_gathered;
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_SHARED_VERTEX_GATHERER_H
