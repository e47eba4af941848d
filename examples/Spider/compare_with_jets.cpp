// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares mean curvature at some vertices with that of CGAL's jet fitting to the vertices within the same radius.

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Spider::parameters;

double mean_curvature_by_jets(Vertex v, const Mesh& mesh, double radius, const Kernel::Vector_3& normal)
{
  std::vector<Kernel::Point_3> points = {mesh.point(v)}; // jet fitting wants the query point first
  for(Vertex w : mesh.vertices())
    if(w != v && CGAL::squared_distance(mesh.point(v), mesh.point(w)) < radius * radius)
      points.push_back(mesh.point(w));
  auto monge = CGAL::Monge_via_jet_fitting<Kernel>()(points.begin(), points.end(), 2, 2);
  monge.comply_wrt_given_normal(normal);
  return -(monge.principal_curvatures(0) + monge.principal_curvatures(1)) / 2; // its sign is the opposite of Spider's
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bunny00.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Not a triangle mesh: " << filename << '\n';
    return EXIT_FAILURE;
  }

  const double radius = argc > 2 ? std::atof(argv[2]) : 0.03;
  std::cout << "Spider\tjets\n";
  for(std::size_t i = 0; i < mesh.number_of_vertices(); i += mesh.number_of_vertices() / 10 + 1)
  {
    const Vertex v(static_cast<Mesh::size_type>(i));
    const auto estimate = CGAL::Spider::estimate_curvature(v, mesh, params::geodesic_radius(radius));
    std::cout << estimate.mean_curvature() << '\t' << mean_curvature_by_jets(v, mesh, radius, estimate.normal) << '\n';
  }
  return EXIT_SUCCESS;
}
