// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The README's program: reads a mesh, and prints the mean curvature at its vertices.

//! [all]
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider.h>
#include <CGAL/Surface_mesh.h>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace Spider = CGAL::Spider;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh))
    return 1;
  auto curvature = mesh.add_property_map<Mesh::Vertex_index, Spider::Curvature_estimate_3<Kernel>>("v:curvature").first;
  const double radius = Spider::suggest_geodesic_radius(mesh); // or the size of the smallest feature of interest
  Spider::estimate_vertex_curvatures(mesh, curvature, Spider::parameters::geodesic_radius(radius));
  for(auto v : mesh.vertices())
    std::cout << mesh.point(v) << ": " << curvature[v].mean_curvature() << '\n';
}
//! [all]
