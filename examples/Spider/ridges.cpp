// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Extracts the ridges and valleys of a mesh, and writes them as an OBJ.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/extract_ridges.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Estimate = CGAL::Spider::Curvature_estimate_3<Kernel>;
using Ridge = CGAL::Spider::Ridge_3<Mesh>;

namespace params = CGAL::Spider::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Not a triangle mesh: " << filename << '\n';
    return EXIT_FAILURE;
  }
  const double radius = argc > 2 ? std::atof(argv[2]) : 0.06;

  //! [ridges]
  auto curvature = mesh.add_property_map<Mesh::Vertex_index, Estimate>("v:curvature").first;
  CGAL::Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, curvature,
                                                                            params::geodesic_radius(radius));
  std::vector<Ridge> lines;
  CGAL::Spider::extract_ridges(mesh, curvature, std::back_inserter(lines), params::geodesic_radius(radius));
  //! [ridges]

  std::ofstream out("ridges.obj");
  std::size_t number_of_ridges = 0, number_of_points = 0;
  for(const Ridge& line : lines)
  {
    number_of_ridges += line.kind == CGAL::Spider::ridge;
    for(const Kernel::Point_3& p : line.points)
      out << "v " << p << '\n';
    out << 'l';
    for(std::size_t i = 0; i < line.points.size(); ++i)
      out << ' ' << ++number_of_points; // OBJ counts from one
    out << '\n';
  }
  std::cout << number_of_ridges << " ridges and " << lines.size() - number_of_ridges << " valleys\n";
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
