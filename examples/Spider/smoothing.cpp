// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Takes noise off a mesh by the geodesic rings around its vertices, and keeps its sharp edges, borders and volume.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/smooth_by_geodesic_rings.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace Spider = CGAL::Spider;
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
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  PMP::detect_sharp_edges(mesh, 80, is_sharp);

  //! [smoothing]
  const auto done = Spider::smooth_by_geodesic_rings<CGAL::Parallel_if_available_tag>(
    mesh, params::smoothing_factor(0.2).number_of_iterations(10).edge_is_constrained_map(is_sharp));
  //! [smoothing]
  std::cout << done.number_of_iterations << " rounds moved vertices by " << done.mean_displacement << ", at most by "
            << done.greatest_displacement << "; volume " << done.volume_before << " before, " << done.volume_after
            << " after\n";
  if(argc > 2)
    CGAL::IO::write_polygon_mesh(argv[2], mesh, CGAL::parameters::stream_precision(17));
}
