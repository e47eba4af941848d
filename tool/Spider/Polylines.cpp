// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Polylines.h"

#include "VTP_writer.h"

#include <boost/algorithm/string/predicate.hpp>

#include <fstream>
#include <limits>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

void write_obj(std::ostream& out, const Polylines& polylines)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  std::size_t next = 1; // OBJ counts vertices from 1
  std::string group;
  for(const Polyline& line : polylines.lines)
  {
    if(line.group != group)
      out << "g " << (group = line.group) << '\n';
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

void write_vtp(std::ostream& out, const Polylines& polylines)
{
  std::vector<double> coordinates;
  std::vector<long long> connectivity, ends;
  for(const Polyline& line : polylines.lines)
  {
    for(const auto& p : line.points)
    {
      connectivity.push_back(static_cast<long long>(connectivity.size()));
      coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
    }
    ends.push_back(static_cast<long long>(connectivity.size()));
  }

  VTP_writer writer(out, connectivity.size(), ends.size(), 0);
  for(const std::string& comment : polylines.comments)
    writer.comment(comment);
  writer.open("CellData", "Scalars=\"" + polylines.numbers.front().first + "\"");
  for(const auto& [name, values] : polylines.numbers)
    writer.array(name, values);
  for(const auto& [name, values] : polylines.codes)
    writer.array(name, values);
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

bool is_polylines_file(const std::string& file) { return is_obj(file) || boost::algorithm::iends_with(file, ".vtp"); }

void write_polylines(const std::string& file, const Polylines& polylines)
{
  std::ofstream out(file, std::ios::binary);
  if(!out)
    throw File_error(file, "can't be written");
  if(is_obj(file))
    write_obj(out, polylines);
  else
    write_vtp(out, polylines);
  if(!out.flush())
    throw File_error(file, "can't be written to its end");
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
