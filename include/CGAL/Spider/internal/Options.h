// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameters that are plain values: read once, checked once, defaults filled in.

#ifndef CGAL_SPIDER_INTERNAL_OPTIONS_H
#define CGAL_SPIDER_INTERNAL_OPTIONS_H

#include <CGAL/Spider/internal/Limb_rule.h>
#include <CGAL/Spider/internal/Spider_fit.h>
#include <CGAL/Spider/internal/check_parameter.h>
#include <CGAL/Spider/parameters.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Spider {
namespace internal {

template <typename Scalar>
struct Options
{
  Estimator estimator;
  Limb_rule<Scalar> limb_rule;
  int number_of_directions;                  ///< over a half turn; 0: as many as the radius asks for
  int polynomial_degree = 2;                 ///< (paper, 2.6)
  Scalar resampling_step = Scalar(0.1);      ///< in units of the radius (paper, 2.6)
  int number_of_iterations = 10;             ///< at most (paper, 2.6)
  Scalar convergence_angle;                  ///< radians: the iteration rests when the normal moves less
  First_normal first_normal = neighbourhood;
  Scalar mean_edge_length = nan<Scalar>();   ///< only known where number_of_directions is 0

  explicit Options(Estimator of)
    : estimator(of), limb_rule(of == section_fit ? arc_length : tangential_distance),
      number_of_directions(of == section_fit ? 64 : 0), // (paper, 2.6)
      convergence_angle(of == section_fit ? Scalar(1e-3) : Scalar(0.3))
  {
  }

  /// returns how many directions a spider takes: the fewest that keep the error within 5 % of that of very many, since
  /// the vertices at the rim must still be met.
  int number_of_directions_at(Scalar radius) const
  {
    constexpr int fewest = 16, most = 1 << 10;
    constexpr Scalar per_edge_length = Scalar(2.5);
    if(number_of_directions > 0)
      return number_of_directions;
    const Scalar wanted = std::ceil(per_edge_length * radius / mean_edge_length);
    return wanted > fewest ? wanted < most ? static_cast<int>(wanted) : most : fewest;
  }
};

/// `default_estimator` is the one whose defaults hold where no estimator is named.
template <typename Scalar, typename NamedParameters>
Options<Scalar> read_options(const NamedParameters& np, Estimator default_estimator)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  namespace tags = Spider::internal_np;

  // Read wide and signed, so that a negative number is told as what it is.
  const auto whole = [](auto value) { return static_cast<long long>(value); };
  const auto real = [](auto value) { return static_cast<Scalar>(value); };

  Options<Scalar> options(choose_parameter(get_parameter(np, tags::estimator), default_estimator));
  const Options<Scalar> defaults = options;
  options.limb_rule.measure = choose_parameter(get_parameter(np, tags::limb_measure), defaults.limb_rule.measure);
  options.first_normal = choose_parameter(get_parameter(np, tags::first_normal), defaults.first_normal);

  const auto given_directions = get_parameter(np, tags::number_of_directions);
  if constexpr(!std::is_same<std::decay_t<decltype(given_directions)>, tags::Param_not_found>::value)
  {
    const long long directions = whole(given_directions);
    constexpr long long most = 1 << 16; // closer than a ten-thousandth of a radian they are all the same
    const bool pairs = options.estimator == section_fit;
    check_parameter(pairs ? directions >= 2 && directions <= most && directions % 2 == 0
                          : directions >= 3 && directions <= most,
                    "number_of_directions", directions,
                    pairs ? "give an even number from 2 to 65536, since section_fit compares orthogonal pairs"
                          : "give a number from 3 to 65536");
    options.number_of_directions = static_cast<int>(directions);
  }

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

  const Scalar crossing_angle =
    real(choose_parameter(get_parameter(np, tags::minimum_crossing_angle), Scalar(30))); // degrees
  check_parameter(crossing_angle >= 0 && crossing_angle <= 90, "minimum_crossing_angle", crossing_angle,
                  "give an angle from 0 to 90 degrees");
  options.limb_rule.sine_of_minimum_crossing_angle = std::sin(crossing_angle * Scalar(CGAL_PI / 180));
  return options;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_OPTIONS_H
