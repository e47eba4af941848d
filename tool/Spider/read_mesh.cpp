// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/IO/read_ply_points.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

struct Polygon_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
};

bool is_finite(const Kernel::Point_3& p)
{
  return CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()) && CGAL::is_finite(p.z());
}

Polygon_soup read_polygon_soup(const std::string& file)
{
  if(!std::ifstream(file))
    throw Unusable_mesh(file, "can't be opened");

  Polygon_soup soup;
  if(!CGAL::IO::read_polygon_soup(file, soup.points, soup.polygons))
    throw Unusable_mesh(file, "can't be read as an OFF, OBJ, PLY or STL file (its name must end in one of these)");
  if(!std::all_of(soup.points.begin(), soup.points.end(), is_finite))
    throw Unusable_mesh(file, "has a coordinate that isn't a finite number");
  for(const auto& polygon : soup.polygons)
    for(std::size_t corner : polygon)
      if(corner >= soup.points.size())
        throw Unusable_mesh(file, "has a face with a vertex that doesn't exist");
  return soup;
}

std::size_t number_of_edges(const Polygon_soup& soup)
{
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for(const auto& polygon : soup.polygons)
    for(std::size_t i = 0; i < polygon.size(); ++i)
      edges.insert(std::minmax(polygon[i], polygon[(i + 1) % polygon.size()]));
  return edges.size();
}

// A soup that is a mesh as it stands keeps its vertices in their order. Otherwise corners at one place become one
// vertex and faces are turned to agree, as files without vertices of their own need it (STL), and where parts of the
// surface meet at a single vertex each gets its own. A soup that would have to be cut along an edge is refused, since
// that would change what was asked about.
void make_manifold(Polygon_soup& soup, const std::string& file)
{
  namespace PMP = CGAL::Polygon_mesh_processing;

  if(PMP::is_polygon_soup_a_polygon_mesh(soup.polygons))
    return;
  PMP::repair_polygon_soup(soup.points, soup.polygons);
  const std::size_t edges = number_of_edges(soup);
  PMP::orient_polygon_soup(soup.points,
                           soup.polygons); // where faces don't fit together it gives them points of their own
  if(number_of_edges(soup) != edges || !PMP::is_polygon_soup_a_polygon_mesh(soup.polygons))
    throw Unusable_mesh(file, "isn't an orientable manifold: faces meet in more than pairs along an edge, "
                              "or can't be turned to agree");
}

using Point_with_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;

std::vector<Point_with_normal> read_normals_of_off(std::istream& in)
{
  Polygon_soup soup;
  std::vector<Kernel::Vector_3> normals;
  CGAL::IO::read_OFF(in, soup.points, soup.polygons,
                     CGAL::parameters::vertex_normal_output_iterator(std::back_inserter(normals)).verbose(false));
  std::vector<Point_with_normal> result;
  for(std::size_t i = 0; i < normals.size(); ++i)
    result.emplace_back(soup.points[i], normals[i]);
  return result;
}

// What the file doesn't have CGAL makes zero.
std::vector<Point_with_normal> read_normals_of_ply(std::istream& in)
{
  std::vector<Point_with_normal> result;
  CGAL::IO::read_PLY<Point_with_normal>(
    in, std::back_inserter(result),
    CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
      .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>()));
  return result;
}

} // namespace

Mesh read_mesh(const std::string& file)
{
  namespace PMP = CGAL::Polygon_mesh_processing;

  Polygon_soup soup = read_polygon_soup(file);
  make_manifold(soup, file);
  if(soup.polygons.empty())
    throw Unusable_mesh(file, "has no faces, or none with three different vertices");
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  if(!CGAL::is_triangle_mesh(mesh) && !PMP::triangulate_faces(mesh))
    throw Unusable_mesh(file, "has a polygon that can't be triangulated");
  return mesh;
}

// Repair may have renumbered the vertices, but left them where they were; where points became one, so do their normals.
std::vector<Kernel::Vector_3> read_vertex_normals(const std::string& file, const Mesh& mesh)
{
  std::ifstream in(file, std::ios::binary);
  const bool is_off = boost::algorithm::iends_with(file, ".off"), is_ply = boost::algorithm::iends_with(file, ".ply");
  std::map<Kernel::Point_3, Kernel::Vector_3> normal_at;
  if(is_off || is_ply)
    for(const auto& [point, normal] : is_off ? read_normals_of_off(in) : read_normals_of_ply(in))
      if(const auto [there, is_new] = normal_at.emplace(point, normal); !is_new)
        there->second = there->second + normal;
  if(std::all_of(normal_at.begin(), normal_at.end(), [](const auto& at) { return at.second == CGAL::NULL_VECTOR; }))
    throw Unusable_mesh(file, "has no normals of vertices (PLY files have them as nx, ny, nz, OFF files as NOFF)");
  std::vector<Kernel::Vector_3> normals;
  for(Vertex v : mesh.vertices())
    normals.push_back(normal_at.at(mesh.point(v)));
  return normals;
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
