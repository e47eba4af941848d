// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shape.h"
#include "grids.h"
#include "mesh_implicit.h"

#include <Eigen/Dense>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <stdexcept>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

const double pi = boost::math::constants::pi<double>();

Eigen::Vector3d to_eigen(const Point& p) { return {p.x(), p.y(), p.z()}; }
Vector to_vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// The axes of a grid over a surface that is `proportion` times as long along its first coordinate as along its second.
std::pair<Axis, Axis> grid_axes(std::size_t number_of_vertices, double proportion, const Rows& rows, bool first_closed,
                                bool second_closed)
{
  const double count = static_cast<double>(number_of_vertices);
  const auto first = static_cast<std::size_t>(std::lround(std::sqrt(count * proportion * rows.crowding)));
  const auto second = static_cast<std::size_t>(std::lround(count / static_cast<double>(first)));
  return {{first, first_closed}, {second, second_closed}};
}

// The graph z = f(x, y) over [-1.5, 1.5]^2, with upward normals.
class Graph : public Shape
{
public:
  // f, its gradient and its second derivatives
  struct Height
  {
    double f, fx, fy, fxx, fxy, fyy;
  };

  Graph(std::string name, std::function<Height(double, double)> height)
    : label(std::move(name)), height(std::move(height))
  {}

  std::string name() const override { return label; }

  Level level(const Point& p) const override
  {
    const Height h = height(p.x(), p.y());
    Level result{p.z() - h.f, {-h.fx, -h.fy, 1}, Eigen::Matrix3d::Zero()};
    result.Hessian.topLeftCorner<2, 2>() << -h.fxx, -h.fxy, -h.fxy, -h.fyy;
    return result;
  }

  Mesh tessellate(std::size_t number_of_vertices, const Rows& rows) const override
  {
    return make_grid(grid_axes(number_of_vertices, 1, rows, false, false), [&](double s, double t) {
      const double x = half_width * (2 * rows.position(s) - 1), y = half_width * (2 * t - 1);
      return Point(x, y, height(x, y).f);
    });
  }

private:
  static constexpr double half_width = 1.5;

  std::string label;
  std::function<Height(double, double)> height;
};

// The cylinder of radius 1 and height 2 around the z axis.
class Cylinder : public Shape
{
public:
  std::string name() const override { return "cylinder"; }

  Level level(const Point& p) const override
  {
    Level result{p.x() * p.x() + p.y() * p.y() - 1, {2 * p.x(), 2 * p.y(), 0}, Eigen::Matrix3d::Zero()};
    result.Hessian.diagonal() << 2, 2, 0;
    return result;
  }

  Mesh tessellate(std::size_t number_of_vertices, const Rows& rows) const override
  {
    return make_grid(grid_axes(number_of_vertices, pi, rows, true, false), [&](double s, double t) {
      const double angle = 2 * pi * rows.position(s);
      return Point(std::cos(angle), std::sin(angle), 2 * t - 1);
    });
  }
};

// The torus around the z axis.
class Torus : public Shape
{
public:
  std::string name() const override { return "torus"; }

  // Twice the tube's own distance function: rho is the distance from the axis; F = (rho - R)^2 + z^2 - r^2.
  Level level(const Point& p) const override
  {
    const double rho = std::hypot(p.x(), p.y());
    const Eigen::Vector3d outwards(p.x() / rho, p.y() / rho, 0), around(-outwards.y(), outwards.x(), 0);
    const double from_circle = rho - centre_line;
    Level result;
    result.value = from_circle * from_circle + p.z() * p.z() - tube * tube;
    result.gradient = 2 * from_circle * outwards + 2 * p.z() * Eigen::Vector3d::UnitZ();
    result.Hessian = 2 * outwards * outwards.transpose() + 2 * from_circle / rho * around * around.transpose();
    result.Hessian(2, 2) += 2;
    return result;
  }

  Mesh tessellate(std::size_t number_of_vertices, const Rows& rows) const override
  {
    // cells are square half-way between the inner and the outer equator
    return make_grid(grid_axes(number_of_vertices, centre_line / tube, rows, true, true), [&](double s, double t) {
      const double longitude = 2 * pi * rows.position(s), latitude = 2 * pi * t;
      const double rho = centre_line + tube * std::cos(latitude);
      return Point(rho * std::cos(longitude), rho * std::sin(longitude), tube * std::sin(latitude));
    });
  }

private:
  static constexpr double centre_line = 1;
  static constexpr double tube = 0.4;
};

// A closed surface that every ray from the origin meets once. Its first coordinate is the colatitude.
class Star_shape : public Shape
{
public:
  Mesh tessellate(std::size_t number_of_vertices, const Rows& rows) const override
  {
    Mesh mesh = base_mesh(number_of_vertices);
    for(auto v : mesh.vertices())
    {
      const Eigen::Vector3d direction = to_eigen(mesh.point(v)).normalized();
      const double colatitude = pi * rows.position(std::acos(direction.z()) / pi);
      const double longitude = std::atan2(direction.y(), direction.x());
      mesh.point(v) = on_ray(
        {std::sin(colatitude) * std::cos(longitude), std::sin(colatitude) * std::sin(longitude), std::cos(colatitude)});
    }
    return mesh;
  }

protected:
  virtual Mesh base_mesh(std::size_t number_of_vertices) const { return make_icosphere(number_of_vertices); }

  // where the ray in the given direction meets the surface: Newton's method along the ray, from outside
  Point on_ray(const Eigen::Vector3d& direction) const
  {
    constexpr int rounds = 20; // far from the surface they halve the distance, near it they square it
    double length = 1.5;       // all of them fit into that ball
    for(int round = 0; round < rounds; ++round)
    {
      const Level here = level(CGAL::ORIGIN + to_vector(length * direction));
      length -= here.value / here.gradient.dot(direction);
    }
    return CGAL::ORIGIN + to_vector(length * direction);
  }
};

// The ellipsoid with the given semi-axes; the unit sphere is one.
class Ellipsoid : public Star_shape
{
public:
  Ellipsoid(std::string name, const Eigen::Vector3d& axes)
    : label(std::move(name)), inverse_squares(axes.cwiseProduct(axes).cwiseInverse())
  {}

  std::string name() const override { return label; }

  Level level(const Point& point) const override
  {
    const Eigen::Vector3d p = to_eigen(point), scaled = inverse_squares.cwiseProduct(p);
    return {p.dot(scaled) - 1, 2 * scaled, Eigen::Matrix3d((2 * inverse_squares).asDiagonal())};
  }

private:
  std::string label;
  Eigen::Vector3d inverse_squares;
};

// A ball with bumps and dents, known by its equation alone and meshed by CGAL's mesher:
// |p|^2 - 1 + c (sin 3x sin 3y + sin 3y sin 3z + sin 3z sin 3x) = 0
class Bumpy_ball : public Star_shape
{
public:
  std::string name() const override { return "implicit"; }

  Level level(const Point& point) const override
  {
    const Eigen::Array3d p = to_eigen(point).array(), sine = (frequency * p).sin(), cosine = (frequency * p).cos();
    const Eigen::Array3d others = sine.sum() - sine;
    Level result;
    result.value = p.square().sum() - 1 + depth * (sine * others).sum() / 2;
    result.gradient = 2 * p + depth * frequency * cosine * others;
    result.Hessian = depth * frequency * frequency * cosine.matrix() * cosine.matrix().transpose();
    result.Hessian.diagonal() = 2 - depth * frequency * frequency * sine * others;
    return result;
  }

protected:
  Mesh base_mesh(std::size_t number_of_vertices) const override
  {
    return mesh_implicit([this](const Point& p) { return level(p).value; }, number_of_vertices);
  }

private:
  static constexpr double frequency = 3;
  static constexpr double depth = 0.2; // deep enough for saddles, too shallow for a ray to meet the surface twice
};

Graph::Height saddle(double x, double y) { return {(x * x - y * y) / 2, x, -y, 1, 0, -1}; }

Graph::Height monkey_saddle(double x, double y)
{
  return {x * x * x / 3 - x * y * y, x * x - y * y, -2 * x * y, 2 * x, -2 * y, -2 * x};
}

Graph::Height waves(double x, double y)
{
  constexpr double height = 0.15, frequency = 4;
  const double sx = std::sin(frequency * x), cx = std::cos(frequency * x);
  const double sy = std::sin(frequency * y), cy = std::cos(frequency * y);
  const double slope = height * frequency, bend = slope * frequency;
  return {height * sx * cy, slope * cx * cy, -slope * sx * sy, -bend * sx * cy, -bend * cx * sy, -bend * sx * cy};
}

using Shape_makers = std::vector<std::pair<std::string, std::function<Shape_ptr()>>>;

const Shape_makers& shape_makers()
{
  static const Shape_makers makers = {
    {"sphere", [] { return std::make_unique<Ellipsoid>("sphere", Eigen::Vector3d(1, 1, 1)); }},
    {"torus", [] { return std::make_unique<Torus>(); }},
    {"ellipsoid", [] { return std::make_unique<Ellipsoid>("ellipsoid", Eigen::Vector3d(1, 0.7, 0.4)); }},
    {"saddle", [] { return std::make_unique<Graph>("saddle", saddle); }},
    {"waves", [] { return std::make_unique<Graph>("waves", waves); }},
    {"cylinder", [] { return std::make_unique<Cylinder>(); }},
    {"monkey_saddle", [] { return std::make_unique<Graph>("monkey_saddle", monkey_saddle); }},
    {"implicit", [] { return std::make_unique<Bumpy_ball>(); }},
  };
  return makers;
}

} // namespace

Estimate curvature_of_level_set(const Level& level)
{
  const double slope = level.gradient.norm();
  const Eigen::Vector3d normal = level.gradient / slope;
  const Eigen::Vector3d first = normal.unitOrthogonal(), second = normal.cross(first);

  // The derivative of the unit normal within the tangent plane, whose eigenvalues are the principal curvatures: the
  // normal turns towards the direction of travel where the surface bends away from it, hence the sign.
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << first, second;
  const Eigen::Matrix2d turning = tangents.transpose() * level.Hessian * tangents / slope;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(turning);

  const Eigen::Vector3d max_direction = tangents * principal.eigenvectors().col(1);
  Estimate result;
  result.min_curvature = principal.eigenvalues()[0];
  result.max_curvature = principal.eigenvalues()[1];
  result.max_direction = to_vector(max_direction);
  result.min_direction = to_vector(max_direction.cross(normal));
  result.normal = to_vector(normal);
  return result;
}

Estimate Shape::truth(const Point& p) const { return curvature_of_level_set(level(p)); }

Point Shape::project(const Point& p) const
{
  constexpr int rounds = 6; // convergence is quadratic, from a fraction of an edge away
  Eigen::Vector3d position = to_eigen(p);
  for(int round = 0; round < rounds; ++round)
  {
    const Level here = level(CGAL::ORIGIN + to_vector(position));
    position -= here.value / here.gradient.squaredNorm() * here.gradient;
  }
  return CGAL::ORIGIN + to_vector(position);
}

std::vector<std::string> shape_names()
{
  std::vector<std::string> names;
  for(const auto& maker : shape_makers())
    names.push_back(maker.first);
  return names;
}

Shape_ptr make_shape(const std::string& name)
{
  std::string known;
  for(const auto& maker : shape_makers())
  {
    if(maker.first == name)
      return maker.second();
    known += " " + maker.first;
  }
  throw std::invalid_argument("no shape is called \"" + name + "\"; there are:" + known);
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
