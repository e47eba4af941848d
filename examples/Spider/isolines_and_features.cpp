// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Labels a surface as convex, concave, flat and saddle, splits it into connected patches of one label, and extracts the
// lines where mean curvature is zero. Writes the labels as colours of a PLY, and the lines as an OBJ.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/classify_vertices.h>
#include <CGAL/Spider/derived_fields.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/extract_isolines.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Estimate = CGAL::Spider::Curvature_estimate_3<Kernel>;
using Label = CGAL::Spider::Vertex_label;
using Isoline = CGAL::Spider::Isoline_3<Mesh>;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Spider::parameters;

// returns the label of most of a face's corners; of the first one where all three differ.
Label label_of(Mesh::Face_index f, const Mesh& mesh, const Mesh::Property_map<Mesh::Vertex_index, Label>& labels)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  const Label a = labels[mesh.source(h)], b = labels[mesh.target(h)], c = labels[mesh.target(mesh.next(h))];
  return b == c ? b : a;
}

// splits a mesh where the labels of neighbouring faces differ; returns the number of patches.
std::size_t number_patches(Mesh& mesh, const Mesh::Property_map<Mesh::Vertex_index, Label>& labels)
{
  auto is_between_patches = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_between_patches", false).first;
  for(Mesh::Edge_index e : mesh.edges())
    if(!mesh.is_border(e))
    {
      const Mesh::Halfedge_index h = mesh.halfedge(e);
      is_between_patches[e] =
        label_of(mesh.face(h), mesh, labels) != label_of(mesh.face(mesh.opposite(h)), mesh, labels);
    }
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  return PMP::connected_components(mesh, patch, CGAL::parameters::edge_is_constrained_map(is_between_patches));
}

void write_lines(std::ostream& out, const std::vector<Isoline>& lines)
{
  std::size_t number_of_points = 0;
  for(const Isoline& line : lines)
  {
    for(const Kernel::Point_3& p : line.points)
      out << "v " << p << '\n';
    out << 'l';
    for(std::size_t i = 0; i < line.points.size(); ++i)
      out << ' ' << ++number_of_points; // OBJ counts from one
    out << '\n';
  }
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Not a triangle mesh: " << filename << '\n';
    return EXIT_FAILURE;
  }
  const double radius = argc > 2 ? std::atof(argv[2]) : 0.05;
  auto curvature = mesh.add_property_map<Mesh::Vertex_index, Estimate>("v:curvature").first;
  CGAL::Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, curvature,
                                                                            params::geodesic_radius(radius));

  // Give flatness_threshold() to compare meshes with one another; else it is chosen for each.
  //! [labels]
  auto label = mesh.add_property_map<Mesh::Vertex_index, Label>("v:label", CGAL::Spider::unlabelled).first;
  const double threshold = CGAL::Spider::classify_vertices(mesh, curvature, label);
  //! [labels]
  std::cout << number_patches(mesh, label) << " patches, flat up to a curvature of " << threshold << '\n';
  auto color = mesh.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
  for(Mesh::Vertex_index v : mesh.vertices())
    color[v] = CGAL::Spider::label_color(label[v]);
  std::ofstream features("features.ply");

  //! [isolines]
  std::vector<Isoline> lines;
  CGAL::Spider::extract_isolines(mesh, CGAL::Spider::derived_field(curvature, CGAL::Spider::Mean_curvature()), 0,
                                 std::back_inserter(lines));
  //! [isolines]
  std::size_t number_of_closed_lines = 0;
  for(const Isoline& line : lines)
    number_of_closed_lines += line.is_closed;
  std::cout << lines.size() << " lines without mean curvature, " << number_of_closed_lines << " of them closed\n";
  std::ofstream isolines("isolines.obj");
  write_lines(isolines, lines);
  return CGAL::IO::write_PLY(features, mesh) && isolines ? EXIT_SUCCESS : EXIT_FAILURE;
}
