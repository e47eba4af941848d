// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_table.h"

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cstdint>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

// adds a property to the vertices; CGAL writes it under its name without the "v:".
template <typename Value, typename Function>
void add_property(Mesh& mesh, const std::string& name, const Function& value)
{
  auto map = mesh.add_property_map<Vertex, Value>("v:" + name).first;
  for(Vertex v : mesh.vertices())
    map[v] = value(v);
}

void add_column(Mesh& mesh, const Column& column)
{
  const auto& value = column.value;
  if(column.name == "normal") // CGAL writes it as all readers have it: nx, ny, nz
    add_property<Kernel::Vector_3>(mesh, column.name,
                                   [&](Vertex v) { return Kernel::Vector_3(value(v, 0), value(v, 1), value(v, 2)); });
  else if(column.kind == Column::vector)
    for(int i = 0; i < 3; ++i)
      add_property<double>(mesh, column.name + "_" + "xyz"[i], [&](Vertex v) { return value(v, i); });
  else if(column.kind == Column::code)
    add_property<std::uint8_t>(mesh, column.name, [&](Vertex v) { return static_cast<std::uint8_t>(value(v, 0)); });
  else
    add_property<double>(mesh, column.name, [&](Vertex v) { return value(v, 0); });
}

} // namespace

void write_ply(std::ostream& out, Mesh mesh, const Vertex_table& table)
{
  for(const Column& column : table.columns)
    add_column(mesh, column);
  add_property<CGAL::IO::Color>(mesh, "color", table.colour);

  std::string comments;
  for(const std::string& comment : table.comments)
    comments += (comments.empty() ? "" : "\n") + comment;
  CGAL::IO::set_binary_mode(out);
  if(!CGAL::IO::write_PLY(out, mesh, comments))
    out.setstate(std::ios::failbit);
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
