// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Limbs.h"

#include "with_parameters.h"

#include <CGAL/Spider/trace_limbs.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

constexpr unsigned char ring_code = degenerate + 1; // behind the ends of limbs

void check_vertices(const std::vector<std::size_t>& vertices, std::size_t count)
{
  for(std::size_t v : vertices)
    if(v >= count)
      throw std::invalid_argument("--limbs has " + std::to_string(v) + ": give numbers of vertices, from 0 to " +
                                  std::to_string(count - 1));
}

} // namespace

std::vector<Limbs> trace_limbs(const Mesh& mesh, const std::vector<Estimate>& estimates,
                               const std::vector<double>& radius_of_vertex, const Settings& settings,
                               const Mesh_attributes& attributes)
{
  check_vertices(settings.limbs.vertices, mesh.num_vertices());
  std::vector<Limbs> result;
  for(std::size_t v : settings.limbs.vertices)
  {
    result.push_back({v, {}, {}});
    Limbs& spider = result.back();
    if(std::isnan(estimates[v].normal.x()))
      continue;
    with_parameters(radius_parameters(radius_of_vertex), settings.estimation, attributes, [&](const auto& np) {
      Spider::trace_limbs(Vertex(v), estimates[v].normal, mesh, std::back_inserter(spider.limbs), np);
    });
    for(const auto& limb : spider.limbs)
      spider.ring.push_back(limb.polyline.back());
    spider.ring.push_back(spider.ring.front());
  }
  return result;
}

Polylines polylines(const std::vector<Limbs>& spiders)
{
  Polylines result;
  std::vector<double> lengths, vertices;
  std::vector<unsigned char> ends;
  const auto add = [&](const char* group, const Limbs& spider, const std::vector<Kernel::Point_3>& points,
                       bool is_closed, unsigned char end) {
    if(points.size() < 2) // a limb that leaves the mesh at once
      return;
    result.lines.push_back({group, points, is_closed});
    lengths.push_back(length(points));
    vertices.push_back(static_cast<double>(spider.vertex));
    ends.push_back(end);
  };
  for(const Limbs& spider : spiders)
    for(const auto& limb : spider.limbs)
      add("limbs", spider, limb.polyline, false, static_cast<unsigned char>(limb.end));
  for(const Limbs& spider : spiders)
    add("rings", spider, spider.ring, true, ring_code);
  result.comments.push_back(
    "line end: 0 radius_reached, 1 border, 2 feature_edge, 3 slowed, 4 degenerate; 5 for rings");
  result.numbers.emplace_back("length", std::move(lengths));
  result.numbers.emplace_back("vertex", std::move(vertices));
  result.codes.emplace_back("end", std::move(ends));
  return result;
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
