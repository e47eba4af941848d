// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Estimates the curvature at all vertices of a Surface_mesh.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Estimate = CGAL::Spider::Curvature_estimate_3<Kernel>;

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

  // The radius is the size of the smallest feature of interest.
  const double radius = argc > 2 ? std::atof(argv[2]) : 0.1;
  auto curvature = mesh.add_property_map<Mesh::Vertex_index, Estimate>("v:curvature").first;
  CGAL::Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, curvature,
                                                                            params::geodesic_radius(radius));

  for(Mesh::Vertex_index v : mesh.vertices())
    if(curvature[v].is_valid())
      std::cout << mesh.point(v) << ": mean curvature " << curvature[v].mean_curvature() << ", Gaussian curvature "
                << curvature[v].Gaussian_curvature() << '\n';
    else
      std::cout << mesh.point(v) << ": " << curvature[v].status << '\n'; // NaN, and the status says why
  return EXIT_SUCCESS;
}
