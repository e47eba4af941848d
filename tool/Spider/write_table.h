// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_WRITE_TABLE_H
#define CGAL_SPIDER_TOOL_WRITE_TABLE_H

#include "Vertex_table.h"

#include <ostream>
#include <string>

namespace CGAL {
namespace Spider {
namespace tool {

// tells whether write_table() knows the ending of a file's name.
bool is_table_file(const std::string& file);

// writes the mesh and what the table has of its vertices as the ending of the file's name says: PLY, VTP or CSV. Throws
// File_error if it can't.
void write_table(const std::string& file, const Mesh& mesh, const Vertex_table& table);

// The same onto a stream. PLY is binary and has vectors as three numbers, VTP (of VTK and ParaView) holds numbers in
// base 64, and CSV has a line of names and then one for each vertex, beginning with its coordinates.
void write_ply(std::ostream& out, Mesh mesh, const Vertex_table& table);
void write_vtp(std::ostream& out, const Mesh& mesh, const Vertex_table& table);
void write_csv(std::ostream& out, const Mesh& mesh, const Vertex_table& table);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_WRITE_TABLE_H
