// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_SHAPE_H
#define CGAL_SPIDER_BENCHMARK_SHAPE_H

#include "Estimator.h"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

// A function of space with its first and second derivatives at a point.
struct Level
{
  double value;
  Eigen::Vector3d gradient;
  Eigen::Matrix3d Hessian;
};

// The rows of a tessellation, across the surface's first coordinate.
struct Rows
{
  std::function<double(double)> position; // of the row at a share of all rows; maps [0, 1] onto itself, increasing
  double crowding =
    1; // how much closer they are than the columns, on average; closed shapes without grid don't heed it
};

// A surface whose curvature is known exactly: the zero set of a function that grows along the surface's normal.
class Shape
{
public:
  virtual ~Shape() = default;

  virtual std::string name() const = 0;

  // the function, its value negative on the inner side
  virtual Level level(const Point& p) const = 0;

  // a regular mesh of about `number_of_vertices` vertices that lie on the surface, its faces showing the outer side
  virtual Mesh tessellate(std::size_t number_of_vertices, const Rows& rows) const = 0;

  // the principal curvatures and directions and the normal at a point of the surface
  Estimate truth(const Point& p) const;

  // a point of the surface near `p`, which must be near the surface
  Point project(const Point& p) const;
};

using Shape_ptr = std::unique_ptr<Shape>;

// Principal curvatures, directions and normal of the level set that a function has through a point.
Estimate curvature_of_level_set(const Level& level);

// All shapes under comparison, and the one of the given name (std::invalid_argument, naming all, if there is none).
std::vector<std::string> shape_names();
Shape_ptr make_shape(const std::string& name);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_SHAPE_H
