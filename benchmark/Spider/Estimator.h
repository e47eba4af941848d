// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_ESTIMATOR_H
#define CGAL_SPIDER_BENCHMARK_ESTIMATOR_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;

// What an estimator says about one vertex. Whatever it doesn't say stays NaN, and is left out of the measures
// that need it: an estimator of H and K alone leaves the directions alone.
// Curvature is positive where the surface bends away from the normal, which lies on the side that the faces show:
// a sphere with outward normals has two positive curvatures. min_curvature <= max_curvature, signed.
struct Estimate
{
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  double min_curvature = nan;
  double max_curvature = nan;
  Vector min_direction{nan, nan, nan};
  Vector max_direction{nan, nan, nan};
  Vector normal{nan, nan, nan};

  double mean_curvature() const { return (min_curvature + max_curvature) / 2; }
  double Gaussian_curvature() const { return min_curvature * max_curvature; }
};

// One way to estimate curvature at all vertices of a mesh. An adapter is one header in estimators/ with one class.
class Estimator
{
public:
  virtual ~Estimator() = default;

  // short and unique; the options of the programs and the report's tables know the estimator by it
  virtual std::string name() const = 0;

  // one line for the report: where it comes from, what neighbourhood and what normals it was given
  virtual std::string settings() const = 0;

  // whether the answer depends on the radius; one-ring estimators say false and are run once for all radii
  virtual bool uses_radius() const { return true; }

  // fills `out`, one entry per vertex, by vertex index (`out.size() == mesh.num_vertices()`; `mesh` has no garbage).
  // Everything that the estimator needs to build counts as its time. One thread.
  virtual void estimate(const Mesh& mesh, double radius, std::vector<Estimate>& out) const = 0;
};

using Estimators = std::vector<std::unique_ptr<Estimator>>;

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_ESTIMATOR_H
