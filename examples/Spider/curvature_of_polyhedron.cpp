// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Estimates the curvature at all vertices of a Polyhedron_3 whose coordinates are exact numbers.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>

#include <boost/property_map/property_map.hpp>

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Vertex = boost::graph_traits<Polyhedron>::vertex_descriptor;

//! [exact]
// Estimates are approximate: where the mesh has exact numbers they come in double.
using Estimate = CGAL::Spider::Curvature_estimate_3<CGAL::Simple_cartesian<double>>;
//! [exact]

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/sphere966.off");
  Polyhedron polyhedron;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, polyhedron) || !CGAL::is_triangle_mesh(polyhedron))
  {
    std::cerr << "Not a triangle mesh: " << filename << '\n';
    return EXIT_FAILURE;
  }

  // With no radius given it is four mean edge lengths.
  //! [polyhedron]
  std::map<Vertex, Estimate> curvature;
  CGAL::Spider::estimate_vertex_curvatures(polyhedron, boost::make_assoc_property_map(curvature));
  //! [polyhedron]

  for(Vertex v : vertices(polyhedron))
    std::cout << v->point() << ": " << curvature[v].mean_curvature() << ' ' << curvature[v].Gaussian_curvature()
              << '\n';
  return EXIT_SUCCESS;
}
