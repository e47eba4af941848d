// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <fstream>
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

} // namespace tool
} // namespace Spider
} // namespace CGAL
