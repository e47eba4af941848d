// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ridges.h"

#include <CGAL/Spider/extract_ridges.h>

#include <cmath>
#include <iterator>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

// Gradients are averaged over a share of one radius all over the mesh.
double mean_radius(const std::vector<double>& radius_of_vertex)
{
  double sum = 0;
  std::size_t count = 0;
  for(double radius : radius_of_vertex)
    if(std::isfinite(radius)) // where a suggestion has nothing to go by, it is NaN
    {
      sum += radius;
      ++count;
    }
  return sum / static_cast<double>(count);
}

} // namespace

std::vector<Ridge> find_ridges(const Mesh& mesh, const std::vector<Estimate>& estimates,
                               const std::vector<double>& radius_of_vertex, const Ridge_settings& settings)
{
  std::vector<Ridge> ridges;
  extract_ridges(mesh, Array_map<Vertex, const Estimate>{estimates.data()}, std::back_inserter(ridges),
                 Spider::parameters::geodesic_radius(mean_radius(radius_of_vertex))
                   .minimum_strength(settings.minimum_strength.value_or(1))
                   .minimum_sharpness(settings.minimum_sharpness.value_or(0.5)));
  return ridges;
}

Polylines polylines(const std::vector<Ridge>& ridges)
{
  Polylines result;
  std::vector<double> strengths, sharpnesses;
  std::vector<unsigned char> kinds;
  for(const Ridge& line : ridges)
  {
    result.lines.push_back({line.kind == ridge ? "ridges" : "valleys", line.points, line.is_closed});
    strengths.push_back(line.strength);
    sharpnesses.push_back(line.sharpness);
    kinds.push_back(line.kind);
  }
  result.comments.push_back("line kind: 0 ridge, 1 valley");
  result.numbers.emplace_back("strength", std::move(strengths));
  result.numbers.emplace_back("sharpness", std::move(sharpnesses));
  result.codes.emplace_back("kind", std::move(kinds));
  return result;
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
