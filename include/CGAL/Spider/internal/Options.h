// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameters that are plain values: read once, checked once, defaults filled in.

#ifndef CGAL_SPIDER_INTERNAL_OPTIONS_H
#define CGAL_SPIDER_INTERNAL_OPTIONS_H

#include <CGAL/Spider/internal/section_fit.h>
#include <CGAL/Spider/parameters.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace CGAL {
namespace Spider {
namespace internal {

/// throws unless a parameter's value is one that its remedy asks for.
template <typename Value>
void check_parameter(bool is_valid, const char* name, const Value& value, const char* remedy)
{
  if(is_valid)
    return;
  std::ostringstream message;
  message << "Spider: " << name << " is " << value << ": " << remedy;
  throw std::invalid_argument(message.str());
}

template <typename Scalar>
void check_radius(Scalar radius)
{
  check_parameter(radius > 0 && std::isfinite(radius), "geodesic_radius", radius,
                  "give a positive, finite length in the mesh's units, for example 4 mean edge lengths");
}

template <typename Scalar>
struct Options
{
  Estimator estimator = section_fit;
  int number_of_directions = 64;               ///< over a half turn (paper, 2.6)
  int polynomial_degree = 2;                   ///< (paper, 2.6)
  Scalar resampling_step = Scalar(0.1);        ///< in units of the radius (paper, 2.6)
  int number_of_iterations = 10;               ///< at most (paper, 2.6)
  Scalar convergence_angle = Scalar(1e-3);     ///< radians: the iteration rests when the normal moves less
  First_normal first_normal = neighbourhood;
};

template <typename Scalar, typename NamedParameters>
Options<Scalar> read_options(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  namespace tags = Spider::internal_np;

  // Read wide and signed, so that a negative number is told as what it is.
  const Options<Scalar> defaults;
  const auto whole = [](auto value) { return static_cast<long long>(value); };
  const auto real = [](auto value) { return static_cast<Scalar>(value); };

  Options<Scalar> options;
  options.estimator = choose_parameter(get_parameter(np, tags::estimator), defaults.estimator);
  check_parameter(options.estimator == section_fit, "estimator", "surface_fit",
                  "this version offers Spider::section_fit alone");
  options.first_normal = choose_parameter(get_parameter(np, tags::first_normal), defaults.first_normal);

  const long long directions =
    whole(choose_parameter(get_parameter(np, tags::number_of_directions), defaults.number_of_directions));
  constexpr long long most_directions = 1 << 16; // closer than a ten-thousandth of a radian they are all the same
  check_parameter(directions >= 2 && directions <= most_directions && directions % 2 == 0, "number_of_directions",
                  directions, "give an even number from 2 to 65536, since directions are compared in orthogonal pairs");
  options.number_of_directions = static_cast<int>(directions);

  const long long degree =
    whole(choose_parameter(get_parameter(np, tags::polynomial_degree), defaults.polynomial_degree));
  check_parameter(degree >= 2 && degree <= max_polynomial_degree, "polynomial_degree", degree, "give 2, 3 or 4");
  options.polynomial_degree = static_cast<int>(degree);

  options.resampling_step =
    real(choose_parameter(get_parameter(np, tags::resampling_step), defaults.resampling_step));
  constexpr Scalar least_step = Scalar(1e-3); // a thousand samples a limb: more cost time and add nothing
  check_parameter(options.resampling_step >= least_step && options.resampling_step <= 1, "resampling_step",
                  options.resampling_step, "give a share of the radius from 0.001 to 1");

  const long long iterations =
    whole(choose_parameter(get_parameter(np, tags::number_of_iterations), defaults.number_of_iterations));
  constexpr long long most_iterations = 1 << 20;
  check_parameter(iterations >= 1 && iterations <= most_iterations, "number_of_iterations", iterations,
                  "give a number of rounds from 1 to 1048576");
  options.number_of_iterations = static_cast<int>(iterations);

  options.convergence_angle =
    real(choose_parameter(get_parameter(np, tags::convergence_angle), defaults.convergence_angle));
  check_parameter(options.convergence_angle >= 0, "convergence_angle", options.convergence_angle,
                  "give an angle in radians that is not negative");
  return options;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_OPTIONS_H
