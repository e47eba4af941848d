// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of the README on an icosahedron, whose vertices lie on a sphere and so must get one positive answer.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace Spider = CGAL::Spider;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Kernel::Point_3>(mesh);

  auto curvature = mesh.add_property_map<Mesh::Vertex_index, Spider::Curvature_estimate_3<Kernel>>("v:curvature").first;
  Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, curvature,
                                                                      Spider::parameters::geodesic_radius(0.5));

  const double first = curvature[*mesh.vertices().begin()].mean_curvature();
  bool all_alike = first > 0;
  for(auto v : mesh.vertices())
  {
    std::cout << curvature[v].mean_curvature() << '\n';
    all_alike = all_alike && std::abs(curvature[v].mean_curvature() - first) < 0.1 * first;
  }
  return all_alike ? 0 : 1;
}
