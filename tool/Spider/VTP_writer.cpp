// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "VTP_writer.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/predef/other/endian.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

// writes bytes in base 64: six bits to a character, padded to fours of them.
void write_base64(std::ostream& out, std::string bytes)
{
  using namespace boost::archive::iterators;
  using Characters = base64_from_binary<transform_width<const char*, 6, 8>>;

  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  const std::size_t characters = (bytes.size() * 8 + 5) / 6;
  bytes.append(padding, '\0'); // or the last character would be made of what is behind the end
  std::copy_n(Characters(bytes.data()), characters, std::ostreambuf_iterator<char>(out));
  out << std::string(padding, '=');
}

} // namespace

VTP_writer::VTP_writer(std::ostream& out, std::size_t points, std::size_t lines, std::size_t faces) : m_out(out)
{
  m_out << "<?xml version=\"1.0\"?>\n";
  open("VTKFile", std::string("type=\"PolyData\" version=\"1.0\" header_type=\"UInt64\" byte_order=\"") +
                    (BOOST_ENDIAN_LITTLE_BYTE ? "LittleEndian" : "BigEndian") + "\"");
  open("PolyData");
  open("Piece", "NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
                  std::to_string(lines) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(faces) + "\"");
}

VTP_writer::~VTP_writer()
{
  while(!m_open.empty())
    close();
}

void VTP_writer::open(const std::string& element, const std::string& attributes)
{
  m_out << '<' << element << (attributes.empty() ? "" : " ") << attributes << ">\n";
  m_open.push_back(element);
}

void VTP_writer::close()
{
  m_out << "</" << m_open.back() << ">\n";
  m_open.pop_back();
}

void VTP_writer::comment(const std::string& text) { m_out << "<!-- " << text << " -->\n"; }

void VTP_writer::array(const std::string& name, const std::vector<double>& values, int components)
{
  write_array("Float64", name, values, components);
}

void VTP_writer::array(const std::string& name, const std::vector<long long>& values)
{
  write_array("Int64", name, values, 1);
}

void VTP_writer::array(const std::string& name, const std::vector<unsigned char>& values, int components)
{
  write_array("UInt8", name, values, components);
}

template <typename Number>
void VTP_writer::write_array(const char* type, const std::string& name, const std::vector<Number>& values,
                             int components)
{
  const std::uint64_t size = values.size() * sizeof(Number); // goes before the numbers
  std::string bytes(sizeof(size) + size, '\0');
  std::memcpy(bytes.data(), &size, sizeof(size));
  if(!values.empty())
    std::memcpy(bytes.data() + sizeof(size), values.data(), size);
  m_out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
        << "\" format=\"binary\">";
  write_base64(m_out, std::move(bytes));
  m_out << "</DataArray>\n";
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
