// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Estimates curvature on a mechanical part, of each smooth patch by itself: limbs stop at its sharp edges.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace Spider = CGAL::Spider;
namespace params = CGAL::Spider::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Not a triangle mesh: " << filename << '\n';
    return EXIT_FAILURE;
  }

  // Edges at which the normals of the faces turn by more than 40 degrees.
  //! [features]
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  PMP::detect_sharp_edges(mesh, 40, is_sharp);
  //! [features]

  auto curvature = mesh.add_property_map<Mesh::Vertex_index, Spider::Curvature_estimate_3<Kernel>>("v:curvature").first;
  const auto largest = [&] {
    double result = 0;
    for(Mesh::Vertex_index v : mesh.vertices())
      if(curvature[v].is_valid())
        result = std::max(result, curvature[v].curvedness());
    return result;
  };
  Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, curvature);
  std::cout << "largest curvedness across edges:  " << largest() << '\n';
  //! [features call]
  Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, curvature,
                                                                      params::edge_is_constrained_map(is_sharp));
  //! [features call]
  std::cout << "largest curvedness of the patches: " << largest() << '\n';
}
