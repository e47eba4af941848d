// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Estimates the curvature at the point of a mesh that is nearest to given coordinates.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>

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
  const Kernel::Point_3 point =
    argc > 4 ? Kernel::Point_3(std::atof(argv[2]), std::atof(argv[3]), std::atof(argv[4])) : Kernel::Point_3(0, 0, 0.5);

  // A face, and the barycentric coordinates in it: what is estimated at the point is not interpolated from vertices.
  //! [location]
  const auto location = PMP::locate(point, mesh);
  const auto estimate = CGAL::Spider::estimate_curvature(location, mesh, params::geodesic_radius(0.1));
  //! [location]

  std::cout << "at (" << PMP::construct_point(location, mesh) << "), " << estimate.status << ":\n"
            << "  curvature " << estimate.min_curvature << " along (" << estimate.min_direction << ")\n"
            << "  curvature " << estimate.max_curvature << " along (" << estimate.max_direction << ")\n"
            << "  normal (" << estimate.normal << ")\n";
  return estimate.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
