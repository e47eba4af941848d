// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL 6 would have Mesh_3 in the place of Surface_mesher, but still has it; CGAL 5.5's Mesh_3 has no surfaces without
// volume.
#define CGAL_NO_DEPRECATION_WARNINGS

#include "mesh_implicit.h"
#include "grids.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

// the mesher's output with facets of at most the given circumradius
Mesh mesh_with_circumradius(const std::function<double(const Point&)>& function, double circumradius)
{
  using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
  using Traits = Triangulation::Geom_traits;
  using Function = std::function<Traits::FT(const Traits::Point_3&)>;

  constexpr double squared_bound = 1.5 * 1.5;
  constexpr double smallest_angle = 30;    // degrees; the most for which the mesher is proved to end
  constexpr double no_distance_bound = 10; // the size alone decides
  Triangulation triangulation;
  CGAL::Complex_2_in_triangulation_3<Triangulation> complex(triangulation);
  const CGAL::Implicit_surface_3<Traits, Function> surface(
    [&](const Traits::Point_3& p) { return function(Point(p.x(), p.y(), p.z())); },
    Traits::Sphere_3(CGAL::ORIGIN, squared_bound));
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(smallest_angle, circumradius, no_distance_bound);
  CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_tag());

  CGAL::Surface_mesh<Traits::Point_3> raw;
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, raw);
  if(!CGAL::Polygon_mesh_processing::is_outward_oriented(raw))
    CGAL::Polygon_mesh_processing::reverse_face_orientations(raw);
  Mesh mesh;
  CGAL::copy_face_graph(raw, mesh);
  return mesh;
}

} // namespace

Mesh mesh_implicit(const std::function<double(const Point&)>& function, std::size_t number_of_vertices)
{
  constexpr double most_meshed = 20000; // more takes the mesher seconds
  const double wanted = static_cast<double>(number_of_vertices);
  const double pieces = std::ceil(std::sqrt(wanted / most_meshed));
  const double base = wanted / (pieces * pieces);

  // The number of vertices is inversely proportional to the circumradius' square: a coarse mesh tells the factor.
  constexpr double coarse = 0.1;
  const double coarse_count = static_cast<double>(mesh_with_circumradius(function, coarse).number_of_vertices());
  const Mesh mesh = mesh_with_circumradius(function, coarse * std::sqrt(coarse_count / base));
  return refine(mesh, static_cast<unsigned int>(pieces));
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
