// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Keeps estimates on a labelled mesh to one label: limbs stop where the label changes. And has limbs grow less in faces
// of one label than in those of the other.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <limits>
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

  // Labels as a segmentation would give them; here by height. An edge between labels is a feature edge.
  auto label = mesh.add_property_map<Mesh::Face_index, int>("f:label", 0).first;
  for(Mesh::Face_index f : mesh.faces())
    label[f] = mesh.point(mesh.target(mesh.halfedge(f))).y() > 0 ? 1 : 0;
  auto changes_label = mesh.add_property_map<Mesh::Edge_index, bool>("e:changes_label", false).first;
  for(Mesh::Edge_index e : mesh.edges())
  {
    const auto h = mesh.halfedge(e);
    changes_label[e] = !mesh.is_border(e) && label[mesh.face(h)] != label[mesh.face(mesh.opposite(h))];
  }

  // Faces of label 1 count double; those of another label than 0 or 1 would be forbidden ground.
  //! [cost]
  auto cost = mesh.add_property_map<Mesh::Face_index, double>("f:cost", 1).first;
  for(Mesh::Face_index f : mesh.faces())
    cost[f] = label[f] == 0 ? 1 : label[f] == 1 ? 2 : std::numeric_limits<double>::infinity();
  //! [cost]

  for(Mesh::Edge_index e : mesh.edges())
    if(changes_label[e])
    {
      const Mesh::Vertex_index v = mesh.vertex(e, 0);
      const auto at_once = Spider::estimate_curvature(v, mesh);
      //! [cost call]
      const auto of_one_label =
        Spider::estimate_curvature(v, mesh, params::growth_cost_map(cost).edge_is_constrained_map(changes_label));
      //! [cost call]
      std::cout << "mean curvature " << at_once.mean_curvature() << " of both labels, " << of_one_label.mean_curvature()
                << " of one (coverage " << of_one_label.coverage << ")\n";
      return EXIT_SUCCESS;
    }
  std::cout << "no edge between two labels\n";
}
