// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "VTP_writer.h"
#include "write_table.h"

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

void write_columns(VTP_writer& writer, const Mesh& mesh, const Vertex_table& table)
{
  writer.open("PointData", "Scalars=\"color\" Normals=\"normal\"");
  std::vector<unsigned char> colours;
  for(Vertex v : mesh.vertices())
  {
    const CGAL::IO::Color colour = table.colour(v);
    colours.insert(colours.end(), {colour.red(), colour.green(), colour.blue()});
  }
  writer.array("color", colours, 3);
  for(const Column& column : table.columns)
  {
    const int components = column.kind == Column::vector ? 3 : 1;
    std::vector<double> values;
    for(Vertex v : mesh.vertices())
      for(int i = 0; i < components; ++i)
        values.push_back(column.value(v, i));
    if(column.kind == Column::code)
      writer.array(column.name, std::vector<unsigned char>(values.begin(), values.end()));
    else
      writer.array(column.name, values, components);
  }
  writer.close();
}

} // namespace

void write_vtp(std::ostream& out, const Mesh& mesh, const Vertex_table& table)
{
  VTP_writer writer(out, mesh.number_of_vertices(), 0, mesh.number_of_faces());
  for(const std::string& comment : table.comments)
    writer.comment(comment);
  write_columns(writer, mesh, table);

  std::vector<double> coordinates;
  for(Vertex v : mesh.vertices())
    for(int i = 0; i < 3; ++i)
      coordinates.push_back(mesh.point(v)[i]);
  writer.open("Points");
  writer.array("points", coordinates, 3);
  writer.close();

  std::vector<long long> corners, ends;
  for(auto face : mesh.faces())
  {
    for(Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
      corners.push_back(v.idx());
    ends.push_back(static_cast<long long>(corners.size()));
  }
  writer.open("Polys");
  writer.array("connectivity", corners);
  writer.array("offsets", ends);
  writer.close();
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
