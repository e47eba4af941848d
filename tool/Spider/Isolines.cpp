// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Isolines.h"

#include "VTP_writer.h"
#include "fields.h"

#include <CGAL/Spider/extract_isolines.h>

#include <boost/algorithm/string/predicate.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

void write_obj(std::ostream& out, const std::vector<Isolines>& isolines)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  std::size_t next = 1; // OBJ counts vertices from 1
  for(const Isolines& group : isolines)
  {
    out << "g " << group.request.field << "=" << group.request.value << '\n';
    for(const auto& line : group.lines)
    {
      // a closed line ends at the vertex that it starts from
      const std::size_t number_of_vertices = line.points.size() - (line.is_closed ? 1 : 0);
      for(std::size_t i = 0; i < number_of_vertices; ++i)
        out << "v " << line.points[i] << '\n';
      out << 'l';
      for(std::size_t i = 0; i < line.points.size(); ++i)
        out << ' ' << next + i % number_of_vertices;
      out << '\n';
      next += number_of_vertices;
    }
  }
}

void write_vtp(std::ostream& out, const std::vector<Isolines>& isolines)
{
  std::vector<double> coordinates, values;
  std::vector<long long> connectivity, ends;
  std::vector<unsigned char> requests;
  for(std::size_t i = 0; i < isolines.size(); ++i)
    for(const auto& line : isolines[i].lines)
    {
      for(const auto& p : line.points)
      {
        connectivity.push_back(static_cast<long long>(connectivity.size()));
        coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
      }
      ends.push_back(static_cast<long long>(connectivity.size()));
      values.push_back(isolines[i].request.value);
      requests.push_back(static_cast<unsigned char>(i));
    }

  VTP_writer writer(out, connectivity.size(), ends.size(), 0);
  for(std::size_t i = 0; i < isolines.size(); ++i)
    writer.comment("request " + std::to_string(i) + " is for " + isolines[i].request.field);
  writer.open("CellData", "Scalars=\"value\"");
  writer.array("value", values);
  writer.array("request", requests);
  writer.close();
  writer.open("Points");
  writer.array("points", coordinates, 3);
  writer.close();
  writer.open("Lines");
  writer.array("connectivity", connectivity);
  writer.array("offsets", ends);
  writer.close();
}

bool is_obj(const std::string& file) { return boost::algorithm::iends_with(file, ".obj"); }

} // namespace

double Isolines::length() const
{
  double sum = 0;
  for(const auto& line : lines)
    for(std::size_t i = 1; i < line.points.size(); ++i)
      sum += std::sqrt(CGAL::squared_distance(line.points[i - 1], line.points[i]));
  return sum;
}

std::vector<Isolines> extract(const Mesh& mesh, const std::vector<Estimate>& estimates,
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

bool is_isolines_file(const std::string& file) { return is_obj(file) || boost::algorithm::iends_with(file, ".vtp"); }

void write_isolines(const std::string& file, const std::vector<Isolines>& isolines)
{
  std::ofstream out(file, std::ios::binary);
  if(!out)
    throw File_error(file, "can't be written");
  if(is_obj(file))
    write_obj(out, isolines);
  else
    write_vtp(out, isolines);
  if(!out.flush())
    throw File_error(file, "can't be written to its end");
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
