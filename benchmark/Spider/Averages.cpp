// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Averages.h"

#include <cmath>
#include <iomanip>
#include <ostream>
#include <utility>

namespace CGAL {
namespace Spider {
namespace benchmark {

Averages::Averages(std::vector<std::string> estimators, std::vector<std::string> tessellations)
  : estimators(std::move(estimators)), tessellations(std::move(tessellations))
{}

void Averages::Average::add(double figure)
{
  if(std::isnan(figure))
    return;
  sum += figure;
  ++count;
}

double Averages::Average::value() const { return count > 0 ? sum / static_cast<double>(count) : Estimate::nan; }

void Averages::add(double noise, double radius, const std::string& estimator, const std::string& tessellation,
                   const Errors& errors, double microseconds)
{
  const double bad = 1000 * static_cast<double>(errors.wild + errors.nan) / static_cast<double>(errors.vertices);
  Cell& cell = blocks[{noise, radius}][{estimator, tessellation}];
  const std::array<double, figures> found = {errors.H.mean, errors.K.mean, errors.direction.mean, bad, microseconds};
  for(std::size_t i = 0; i < figures; ++i)
    cell[i].add(found[i]);
}

void Averages::print(std::ostream& out) const
{
  constexpr int name_width = 24, width = 9;
  const std::array<const char*, figures> titles = {"H / RMS", "K / RMS^2", "direction, degrees",
                                                   "wild or NaN, per 1000", "microseconds / vertex"};
  out << "Mean errors over interior vertices, averaged over shapes and seeds.\n";
  for(const auto& block : blocks)
  {
    const auto [noise, radius] = block.first;
    out << "\nnoise " << noise << ", " << (radius > 0 ? "radius " + to_text(radius) : std::string("no radius")) << '\n'
        << std::setw(name_width) << "";
    for(const char* title : titles)
      out << " |" << std::setw(width * static_cast<int>(tessellations.size())) << title;
    out << '\n' << std::setw(name_width) << "";
    for(std::size_t i = 0; i < figures; ++i)
    {
      out << " |";
      for(const auto& tessellation : tessellations)
        out << std::setw(width) << tessellation.substr(0, width - 1);
    }
    out << '\n';
    for(const auto& estimator : estimators)
    {
      if(block.second.count({estimator, tessellations.front()}) == 0)
        continue;
      out << std::left << std::setw(name_width) << estimator << std::right;
      for(std::size_t i = 0; i < figures; ++i)
      {
        out << " |";
        for(const auto& tessellation : tessellations)
          out << std::setw(width) << to_text(block.second.at({estimator, tessellation})[i].value());
      }
      out << '\n';
    }
  }
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
