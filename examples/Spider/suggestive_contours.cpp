// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws the suggestive contours of a surface for a viewpoint (DeCarlo, Finkelstein, Rusinkiewicz and Santella 2003):
// the lines on the visible side where radial curvature is zero, and grows towards the viewer. Writes them as an OBJ.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/derived_fields.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/extract_isolines.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Estimate = CGAL::Spider::Curvature_estimate_3<Kernel>;
using Isoline = CGAL::Spider::Isoline_3<Mesh>;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Spider::parameters;

// returns a vector as long as twice a face's area, on the side to which the face points.
Kernel::Vector_3 area_vector(Mesh::Face_index f, const Mesh& mesh)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  const Kernel::Point_3 a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h));
  return CGAL::cross_product(b - a, mesh.point(mesh.target(mesh.next(h))) - a);
}

// returns how fast a scalar, given at the corners of a face, grows along a vector.
template <typename Field>
double derivative(const Field& field, Mesh::Face_index f, const Mesh& mesh, const Kernel::Vector_3& along)
{
  const Kernel::Vector_3 area = area_vector(f, mesh);
  Kernel::Vector_3 gradient = CGAL::NULL_VECTOR;
  for(Mesh::Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
  {
    const Kernel::Vector_3 edge = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
    const double opposite = get(field, mesh.target(mesh.next(h)));
    gradient += opposite * CGAL::cross_product(area, edge) / area.squared_length();
  }
  return gradient * along;
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
  const Kernel::Point_3 viewer =
    argc > 5 ? Kernel::Point_3(std::atof(argv[3]), std::atof(argv[4]), std::atof(argv[5])) : Kernel::Point_3(2, 1, 3);

  auto curvature = mesh.add_property_map<Mesh::Vertex_index, Estimate>("v:curvature").first;
  CGAL::Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, curvature,
                                                                            params::geodesic_radius(radius));
  const auto radial_curvature = CGAL::Spider::radial_curvature_field(curvature, mesh.points(), viewer);
  std::vector<Isoline> lines;
  CGAL::Spider::extract_isolines(mesh, radial_curvature, 0, std::back_inserter(lines));

  // Each segment runs in one face, which its first location names, and in which radial curvature is linear.
  std::ofstream out("suggestive_contours.obj");
  std::size_t number_of_segments = 0;
  for(const Isoline& line : lines)
    for(std::size_t i = 0; i + 1 < line.points.size(); ++i)
    {
      const Mesh::Face_index f = line.locations[i].first;
      const Kernel::Vector_3 view = viewer - line.points[i];
      const bool faces_viewer = area_vector(f, mesh) * view > 0;
      if(!faces_viewer || !(derivative(radial_curvature, f, mesh, view) > 0))
        continue;
      out << "v " << line.points[i] << "\nv " << line.points[i + 1] << "\nl -2 -1\n"; // the last two points
      ++number_of_segments;
    }
  std::cout << number_of_segments << " segments on " << lines.size() << " lines without radial curvature\n";
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
