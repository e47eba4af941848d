// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_COLOUR_H
#define CGAL_SPIDER_TOOL_COLOUR_H

#include <CGAL/IO/Color.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace tool {

// returns the colour of a value between -limit (blue) through 0 (white) to limit (red); values beyond get the ends'
// colours, and what is no number is dark grey, which the map doesn't have otherwise.
inline CGAL::IO::Color diverging_colour(double value, double limit)
{
  // ColorBrewer's RdBu from blue to red, which colour-blind readers can tell apart, without its two nearly black ends
  constexpr std::array<std::array<double, 3>, 9> stops = {{{33, 102, 172},
                                                           {67, 147, 195},
                                                           {146, 197, 222},
                                                           {209, 229, 240},
                                                           {247, 247, 247},
                                                           {253, 219, 199},
                                                           {244, 165, 130},
                                                           {214, 96, 77},
                                                           {178, 24, 43}}};
  if(std::isnan(value))
    return CGAL::IO::Color(64, 64, 64);

  const double share = limit > 0 ? std::clamp(value / limit, -1.0, 1.0) : 0.0;
  const double position = (share + 1) / 2 * (stops.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(position), stops.size() - 2);
  const double weight = position - static_cast<double>(below);
  const auto channel = [&](std::size_t i) {
    return static_cast<unsigned char>(std::lround((1 - weight) * stops[below][i] + weight * stops[below + 1][i]));
  };
  return CGAL::IO::Color(channel(0), channel(1), channel(2));
}

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_COLOUR_H
