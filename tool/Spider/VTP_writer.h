// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_VTP_WRITER_H
#define CGAL_SPIDER_TOOL_VTP_WRITER_H

#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// Writes VTK's XML format for surfaces and lines. CGAL writes meshes in it, but not what their vertices have, and VTK's
// own writer would be a heavy thing to depend on. Numbers are in base 64, since VTK can't read NaN as text.
class VTP_writer
{
public:
  VTP_writer(std::ostream& out, std::size_t points, std::size_t lines, std::size_t faces);
  ~VTP_writer(); // ends what is open

  // opens and closes an element: PointData, CellData, Points, Lines, Polys
  void open(const std::string& element, const std::string& attributes = "");
  void close();

  void comment(const std::string& text);

  // Arrays: names tell what VTK wants of them (connectivity and offsets of cells).
  void array(const std::string& name, const std::vector<double>& values, int components = 1);
  void array(const std::string& name, const std::vector<long long>& values);
  void array(const std::string& name, const std::vector<unsigned char>& values, int components = 1);

private:
  template <typename Number>
  void write_array(const char* type, const std::string& name, const std::vector<Number>& values, int components);

  std::ostream& m_out;
  std::vector<std::string> m_open;
};

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_VTP_WRITER_H
