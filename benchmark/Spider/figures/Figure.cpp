// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Figure.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>

#include <sstream>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

// Pictures don't need more digits than a float has, and so the files are half as large.
template <typename Coordinates>
nlohmann::json triple(const Coordinates& c)
{
  return {static_cast<float>(c.x()), static_cast<float>(c.y()), static_cast<float>(c.z())};
}

} // namespace

Mesh Figure_input::mesh(const std::string& name) const
{
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(data + "/" + name, mesh) || !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error("cannot read a triangle mesh from " + data + "/" + name);
  return mesh;
}

Figure::Figure(int number, std::string title)
{
  m_json = {{"number", number},
            {"title", std::move(title)},
            {"meshes", nlohmann::json::object()},
            {"panels", nlohmann::json::array()},
            {"curves", nlohmann::json::array()},
            {"claims", nlohmann::json::array()}};
}

void Figure::add_mesh(const std::string& name, const Mesh& mesh)
{
  nlohmann::json points, faces;
  for(auto v : mesh.vertices())
    points.push_back(triple(mesh.point(v)));
  for(auto face : mesh.faces())
  {
    nlohmann::json corners;
    for(auto v : mesh.vertices_around_face(mesh.halfedge(face)))
      corners.push_back(v.idx());
    faces.push_back(std::move(corners));
  }
  m_json["meshes"][name] = {{"points", std::move(points)}, {"faces", std::move(faces)}};
}

void Figure::add_panel(const std::string& title, const std::string& mesh)
{
  m_json["panels"].push_back({{"title", title}, {"mesh", mesh}, {"lines", nlohmann::json::object()}});
}

void Figure::add_field(const std::string& name, const std::vector<double>& values)
{
  panel()["field"] = {{"name", name}, {"values", std::vector<float>(values.begin(), values.end())}};
}

void Figure::add_vectors(const std::vector<Vector>& vectors)
{
  for(const Vector& vector : vectors)
    panel()["vectors"].push_back(triple(vector));
}

void Figure::add_lines(const std::string& kind, const std::vector<std::vector<Point>>& lines)
{
  auto& all = panel()["lines"][kind];
  for(const auto& line : lines)
  {
    nlohmann::json points;
    for(const Point& p : line)
      points.push_back(triple(p));
    all.push_back(std::move(points));
  }
}

void Figure::add_points(const std::string& kind, const std::vector<Point>& points)
{
  for(const Point& p : points)
    panel()["points"][kind].push_back(triple(p));
}

void Figure::set(const std::string& name, const nlohmann::json& value) { panel()[name] = value; }

void Figure::add_curve(const std::string& name, const std::vector<double>& x, const std::vector<double>& y)
{
  m_json["curves"].push_back({{"name", name}, {"x", x}, {"y", y}});
}

void Figure::add_claim(const std::string& about, const std::string& paper, const std::string& ours, bool is_reproduced)
{
  m_json["claims"].push_back({{"about", about}, {"paper", paper}, {"ours", ours}, {"reproduced", is_reproduced}});
}

void Figure::add_number(const std::string& about, const std::string& ours)
{
  m_json["claims"].push_back({{"about", about}, {"paper", nullptr}, {"ours", ours}, {"reproduced", nullptr}});
}

std::string digits(double value)
{
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
