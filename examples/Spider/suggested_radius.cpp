// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Estimates curvature with the radius that suits a mesh and its noise, and with one that suits each of its places.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/suggest_adaptive_radii.h>
#include <CGAL/Spider/suggest_geodesic_radius.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Estimate = CGAL::Spider::Curvature_estimate_3<Kernel>;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Spider::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
  {
    std::cerr << "Not a triangle mesh: " << filename << '\n';
    return EXIT_FAILURE;
  }
  auto curvature = mesh.add_property_map<Mesh::Vertex_index, Estimate>("v:curvature").first;

  //! [one radius]
  const double radius = CGAL::Spider::suggest_geodesic_radius(mesh);
  CGAL::Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, curvature,
                                                                            params::geodesic_radius(radius));
  //! [one radius]
  std::cout << "one radius for all: " << radius << '\n';

  // Where the density of vertices varies, so may the radius.
  //! [radii]
  auto radii = mesh.add_property_map<Mesh::Vertex_index, double>("v:radius").first;
  CGAL::Spider::suggest_geodesic_radii<CGAL::Parallel_if_available_tag>(mesh, radii);
  CGAL::Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, curvature,
                                                                            params::geodesic_radius(radii));
  //! [radii]
  const auto [least, greatest] =
    std::minmax_element(mesh.vertices().begin(), mesh.vertices().end(),
                        [&](Mesh::Vertex_index v, Mesh::Vertex_index w) { return radii[v] < radii[w]; });
  std::cout << "one for each vertex: from " << radii[*least] << " to " << radii[*greatest] << '\n';

  // Where the surface bends at a small scale in some places, and in one direction more than in the other, so may limbs.
  //! [limbs]
  auto elongations = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:elongation").first;
  const auto by_direction = params::limb_elongation_map(elongations);
  CGAL::Spider::suggest_adaptive_radii<CGAL::Parallel_if_available_tag>(mesh, radii, by_direction);
  CGAL::Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, curvature,
                                                                            by_direction.geodesic_radius(radii));
  //! [limbs]
  double longest = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
    longest = std::max(longest, std::sqrt(elongations[v].squared_length()));
  std::cout << "limbs up to " << longest << " times as long along something as across\n";

  // What is there at several scales takes one walk.
  //! [several radii]
  const std::vector<double> scales = {radius / 2, radius, 2 * radius};
  auto at_scales = mesh.add_property_map<Mesh::Vertex_index, std::vector<Estimate>>("v:curvature_at_scales").first;
  CGAL::Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, at_scales,
                                                                            params::geodesic_radii(scales));
  //! [several radii]
  for(std::size_t i = 0; i < scales.size(); ++i)
    std::cout << "at radius " << scales[i] << ": mean curvature "
              << at_scales[*mesh.vertices().begin()][i].mean_curvature() << " at the first vertex\n";
  return EXIT_SUCCESS;
}
