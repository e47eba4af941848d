// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL 6 would have Mesh_3 in the place of Surface_mesher, but still has it; CGAL 5.5's Mesh_3 has no surfaces without
// volume.
#define CGAL_NO_DEPRECATION_WARNINGS

#include "mesh_implicit.h"
#include "grids.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_with_circumcenter_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Random.h>
#include <CGAL/Robust_circumcenter_traits_3.h>
#include <CGAL/Surface_mesh_cell_base_3.h>
#include <CGAL/Surface_mesh_vertex_base_3.h>
#include <CGAL/make_surface_mesh.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

// The mesher keeps vertices and cells in ordered sets. Without this their order is that of their addresses, and the
// mesh a different one in every run; with it CGAL orders them by age.
template <typename Base>
class Stamped : public Base
{
public:
  using Base::Base;
  using Has_timestamp = CGAL::Tag_true;

  template <typename Tds>
  struct Rebind_TDS
  {
    using Other = Stamped<typename Base::template Rebind_TDS<Tds>::Other>;
  };

  std::size_t time_stamp() const { return stamp; }
  void set_time_stamp(const std::size_t& value) { stamp = value; }

private:
  std::size_t stamp = static_cast<std::size_t>(-1); // as CGAL's containers mark what has none yet
};

// CGAL's Surface_mesh_default_triangulation_3, stamped
using Traits = CGAL::Robust_circumcenter_traits_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Cell_base =
  CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<Traits, CGAL::Surface_mesh_cell_base_3<Traits>>;
using Triangulation = CGAL::Delaunay_triangulation_3<
  Traits, CGAL::Triangulation_data_structure_3<Stamped<CGAL::Surface_mesh_vertex_base_3<Traits>>, Stamped<Cell_base>>>;

// the mesher's output with facets of at most the given circumradius
Mesh mesh_with_circumradius(const std::function<double(const Point&)>& function, double circumradius)
{
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
  CGAL::get_default_random() = CGAL::Random(0); // which the mesher draws from: the same mesh every time
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
