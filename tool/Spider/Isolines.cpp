// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Isolines.h"

#include "fields.h"

#include <CGAL/Spider/extract_isolines.h>

#include <boost/property_map/function_property_map.hpp>

#include <iterator>
#include <sstream>

namespace CGAL {
namespace Spider {
namespace tool {

double Isolines::length() const
{
  double sum = 0;
  for(const auto& line : lines)
    sum += tool::length(line.points);
  return sum;
}

std::vector<Isolines> find_isolines(const Mesh& mesh, const std::vector<Estimate>& estimates,
                                    const std::vector<Isoline_request>& requests)
{
  std::vector<Isolines> result;
  for(const Isoline_request& request : requests)
  {
    const Field& field = field_of(request.field);
    const auto scalar = boost::make_function_property_map<Vertex>([&](Vertex v) { return field.of(estimates[v]); });
    result.push_back({request, {}});
    extract_isolines(mesh, scalar, request.value, std::back_inserter(result.back().lines));
  }
  return result;
}

Polylines polylines(const std::vector<Isolines>& isolines)
{
  Polylines result;
  std::vector<double> values;
  std::vector<unsigned char> requests;
  for(std::size_t i = 0; i < isolines.size(); ++i)
  {
    const Isoline_request& request = isolines[i].request;
    std::ostringstream group;
    group << request.field << '=' << request.value;
    result.comments.push_back("request " + std::to_string(i) + " is for " + request.field);
    for(const auto& line : isolines[i].lines)
    {
      result.lines.push_back({group.str(), line.points, line.is_closed});
      values.push_back(request.value);
      requests.push_back(static_cast<unsigned char>(i));
    }
  }
  result.numbers.emplace_back("value", std::move(values));
  result.codes.emplace_back("request", std::move(requests));
  return result;
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
