// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Traces the spider of one vertex and writes its limbs as polylines into an OBJ file, which ParaView and Blender show.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/estimate_normal.h>
#include <CGAL/Spider/trace_limbs.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Spider::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Not a triangle mesh: " << filename << '\n';
    return EXIT_FAILURE;
  }

  const Mesh::Vertex_index vertex = *mesh.vertices().begin();
  //! [limbs]
  const auto np = params::geodesic_radius(0.1).number_of_directions(8);
  const Kernel::Vector_3 normal = CGAL::Spider::estimate_normal(vertex, mesh, np);
  std::vector<CGAL::Spider::Limb_3<Mesh>> limbs;
  CGAL::Spider::trace_limbs(vertex, normal, mesh, std::back_inserter(limbs), np);
  //! [limbs]

  std::ofstream out("spider.obj");
  std::size_t number_of_points = 0;
  for(const auto& limb : limbs)
  {
    for(const Kernel::Point_3& p : limb.polyline)
      out << "v " << p << '\n';
    out << 'l';
    for(std::size_t i = 0; i < limb.polyline.size(); ++i)
      out << ' ' << ++number_of_points; // OBJ counts from one
    out << '\n';
    std::cout << "length " << limb.length << ", " << limb.polyline.size() << " points, " << limb.end << '\n';
  }
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
