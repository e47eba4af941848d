// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_JET_ESTIMATOR_H
#define CGAL_SPIDER_TOOL_JET_ESTIMATOR_H

#include "tool_types.h"

#include <limits>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

struct Jet_estimate
{
  double min_curvature = std::numeric_limits<double>::quiet_NaN();
  double max_curvature = std::numeric_limits<double>::quiet_NaN();

  double mean_curvature() const { return (min_curvature + max_curvature) / 2; }
  double Gaussian_curvature() const { return min_curvature * max_curvature; }
};

// fills `points` with v's and those of the vertices that edges connect with v inside the ball of the radius around v.
void collect_connected_points(Vertex v, const Mesh& mesh, double radius, std::vector<Kernel::Point_3>& points);

// CGAL's jet fitting of degree 2, from all connected vertices within a radius (one for each vertex), with Spider's
// signs.
class Jet_estimator
{
public:
  Jet_estimator(const Mesh& mesh, const std::vector<double>& radius_of_vertex);

  // NaN where the neighbourhood has fewer points than the polynomial has coefficients
  Jet_estimate operator()(Vertex v) const;

private:
  const Mesh& m_mesh;
  const std::vector<double>& m_radius_of_vertex;
  std::vector<Kernel::Vector_3> m_normals;
};

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_JET_ESTIMATOR_H
