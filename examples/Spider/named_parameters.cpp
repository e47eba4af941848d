// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Chains named parameters, and compares the published estimator with the default one at a vertex.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace params = CGAL::Spider::parameters;
using CGAL::Spider::estimate_curvature;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Not a triangle mesh: " << filename << '\n';
    return EXIT_FAILURE;
  }
  const Mesh::Vertex_index v = *mesh.vertices().begin();
  //! [chain]
  const auto quick = estimate_curvature(
    v, mesh, params::geodesic_radius(0.1).number_of_directions(16).number_of_iterations(1).geom_traits(Kernel()));
  const auto published = estimate_curvature(v, mesh, params::as_published().geodesic_radius(0.1));
  //! [chain]
  std::cout << "mean curvature " << quick.mean_curvature() << ", as published " << published.mean_curvature() << '\n';

  //! [error]
  try
  {
    estimate_curvature(v, mesh, params::geodesic_radius(-1));
  }
  catch(const std::invalid_argument& error)
  {
    std::cout << error.what() << '\n'; // names the parameter, its value and the remedy
  }
  //! [error]
  return quick.is_valid() && published.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
