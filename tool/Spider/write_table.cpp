// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_table.h"

#include <boost/algorithm/string/predicate.hpp>

#include <array>
#include <fstream>
#include <limits>
#include <utility>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

using Writer = void (*)(std::ostream&, const Mesh&, const Vertex_table&);

constexpr std::array<std::pair<const char*, Writer>, 3> writers = {
  {{".ply", [](std::ostream& out, const Mesh& mesh, const Vertex_table& table) { write_ply(out, mesh, table); }},
   {".vtp", write_vtp},
   {".csv", write_csv}}};

Writer writer_of(const std::string& file)
{
  for(const auto& [ending, writer] : writers)
    if(boost::algorithm::iends_with(file, ending))
      return writer;
  return nullptr;
}

} // namespace

bool is_table_file(const std::string& file) { return writer_of(file) != nullptr; }

void write_table(const std::string& file, const Mesh& mesh, const Vertex_table& table)
{
  std::ofstream out(file, std::ios::binary);
  if(!out)
    throw File_error(file, "can't be written");
  writer_of(file)(out, mesh, table);
  if(!out.flush())
    throw File_error(file, "can't be written to its end");
}

void write_csv(std::ostream& out, const Mesh& mesh, const Vertex_table& table)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "x,y,z";
  for(const Column& column : table.columns)
    if(column.kind == Column::vector)
      for(char axis : {'x', 'y', 'z'})
        out << ',' << column.name << '_' << axis;
    else
      out << ',' << column.name;
  out << '\n';
  for(Vertex v : mesh.vertices())
  {
    out << mesh.point(v).x() << ',' << mesh.point(v).y() << ',' << mesh.point(v).z();
    for(const Column& column : table.columns)
      for(int i = 0; i < (column.kind == Column::vector ? 3 : 1); ++i)
        out << ',' << column.value(v, i);
    out << '\n';
  }
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
