// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads any polygons, repairs and remeshes them, estimates curvature, and writes it as properties and colours of a PLY.

//! [pipeline]
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cstdlib>
#include <fstream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace Spider = CGAL::Spider;

int main(int argc, char* argv[])
{
  Mesh mesh; // oriented as it is read, even from triangles that know nothing of one another, as STL's
  if(!PMP::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bones.off"), mesh))
    return EXIT_FAILURE;
  PMP::triangulate_faces(mesh);
  PMP::stitch_borders(mesh);
  PMP::remove_degenerate_faces(mesh);

  double mean_edge_length = 0;
  for(auto e : mesh.edges())
    mean_edge_length += PMP::edge_length(e, mesh) / double(mesh.number_of_edges());
  PMP::isotropic_remeshing(mesh.faces(), mean_edge_length, mesh);
  mesh.collect_garbage();

  //! [five lines]
  auto curvature = mesh.add_property_map<Mesh::Vertex_index, Spider::Curvature_estimate_3<Kernel>>("v:curvature").first;
  Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(
    mesh, curvature, Spider::parameters::geodesic_radius(Spider::suggest_geodesic_radius(mesh)));
  auto mean = mesh.add_property_map<Mesh::Vertex_index, double>("v:mean_curvature").first;
  for(auto v : mesh.vertices())
    mean[v] = curvature[v].mean_curvature();
  //! [five lines]

  auto label = mesh.add_property_map<Mesh::Vertex_index, Spider::Vertex_label>("v:label").first;
  auto color = mesh.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
  Spider::classify_vertices(mesh, curvature, label);
  for(auto v : mesh.vertices())
    color[v] = Spider::label_color(label[v]);
  std::ofstream out(argc > 2 ? argv[2] : "pipeline.ply");
  return CGAL::IO::write_PLY(out, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
//! [pipeline]
