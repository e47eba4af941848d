// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fuzz_calls.h"
#include "fuzz_checks.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Spider.h>

#include <array>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

namespace fuzz {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;

/// returns a point inside a face, on one of its edges or at a corner.
Location random_location(const Mesh& mesh, Random& random)
{
  std::array<double, 3> weights = {random.real(0, 1), random.real(0, 1), random.real(0, 1)};
  for(std::size_t i = random.below(3); i-- > 0;)
    weights[i] = 0;
  if(random.one_in(8))
    weights[random.below(3)] *= 1e-18;
  const double sum = weights[0] + weights[1] + weights[2];
  if(sum > 0)
    for(double& w : weights)
      w /= sum;
  else
    weights = {0, 0, 1};
  return {Mesh::Face_index(static_cast<Mesh::size_type>(random.below(mesh.number_of_faces()))), weights};
}

Kernel::Vector_3 random_direction(Random& random)
{
  const Kernel::Vector_3 direction = random_vector(random);
  return random.one_in(8) ? direction * random.power_of_ten(-300, 300) : direction;
}

void check(const Spider::Limb_3<Mesh>& limb, double longest)
{
  constexpr double rounding = 1e-9;
  expect(!limb.polyline.empty(), "a limb has a point");
  expect(limb.length >= 0 && limb.length <= longest * (1 + rounding), "a limb is no longer than it may be");
  expect(limb.end != Spider::radius_reached || limb.length > 0, "a limb that reached the radius has a length");
  for(std::size_t i = 1; i < limb.polyline.size(); ++i)
    expect(all_finite(limb.polyline[i]), "a limb goes through points");
  if(limb.length > 0 && std::isfinite(limb.length)) // a mesh may span all numbers, and a limb be longer than these
    expect(Spider::resample(limb, limb.length / 7.5).size() >= 2, "a limb is resampled from its start to its end");
}

template <typename Query, typename NamedParameters>
void trace(const Query& query, const Mesh& mesh, double longest, const NamedParameters& np, Random& random)
{
  const Kernel::Vector_3 normal = random_direction(random), direction = random_direction(random);
  check(Spider::trace_limb(query, normal, direction, mesh, np), longest);
  std::vector<Spider::Limb_3<Mesh>> limbs;
  Spider::trace_limbs(query, normal, mesh, std::back_inserter(limbs), np);
  for(const auto& limb : limbs)
    check(limb, longest);
  std::vector<Kernel::Point_3> ring;
  Spider::geodesic_ring(query, normal, mesh, std::back_inserter(ring), np);
  expect(ring.size() == limbs.size(), "a ring has a point per limb");
  for(const auto& polyline : Spider::trace_sphere_section(query, mesh, np))
    expect(polyline.size() >= 2, "a section has a segment");
  const auto section = Spider::estimate_normal_curvature(query, normal, direction, mesh, np);
  const bool is_valid = section.status == Spider::ok || section.status == Spider::partial;
  expect(is_valid ? std::isfinite(section.curvature) && std::isfinite(section.tangent_slope) && section.residual >= 0
                  : std::isnan(section.curvature),
         "a normal curvature is finite, or NaN with a status");
}

template <typename Query, typename NamedParameters>
void estimate(const Query& query, const Mesh& mesh, const NamedParameters& np)
{
  expect_unit_or_none(Spider::estimate_normal(query, mesh, np));
  expect_sound(Spider::estimate_curvature(query, mesh, np));
}

/// calls with maps, of which a single query refuses what is wrong there.
template <typename Query>
void estimate_by_maps(const Query& query, const Mesh& mesh, const Settings& settings)
{
  try
  {
    estimate(query, mesh, settings.by_maps());
  }
  catch(const std::invalid_argument&)
  {
    expect(settings.radii_have_slips, "radii that are right aren't refused");
  }
}

template <typename Query>
void call(const Query& query, const Mesh& mesh, const Settings& settings, Random& random)
{
  // By tangential distance, a limb that climbs a wall is longer than the radius, and ends with a segment of any length.
  const bool by_arc = settings.limb_measure == Spider::arc_length;
  if(!settings.are_valid)
    return estimate(query, mesh, settings.all());
  switch(random.below(5))
  {
    case 0: trace(query, mesh, by_arc ? settings.radius : infinity, settings.all(), random); break;
    case 1: estimate_by_maps(query, mesh, settings); break;
    case 2: estimate(query, mesh, settings.few()); break;
    default: estimate(query, mesh, settings.all()); break;
  }
}

template <typename NamedParameters>
void estimate_all(const Mesh& mesh, const NamedParameters& np)
{
  std::vector<Spider::Curvature_estimate_3<Kernel>> estimates;
  Spider::estimate_curvatures(mesh.vertices(), mesh, std::back_inserter(estimates), np);
  for(const auto& e : estimates)
    expect_sound(e);
  Mesh copy = mesh;
  const auto normals = copy.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:estimated_normal").first;
  Spider::estimate_vertex_normals(copy, normals, np);
  for(Mesh::Vertex_index v : copy.vertices())
    expect_unit_or_none(normals[v]);
}

void label(Mesh mesh, const Settings& settings, Random& random)
{
  using Estimate = Spider::Curvature_estimate_3<Kernel>;
  const auto curvature = mesh.add_property_map<Mesh::Vertex_index, Estimate>("v:curvature").first;
  const auto labels = mesh.add_property_map<Mesh::Vertex_index, Spider::Vertex_label>("v:label").first;
  Spider::estimate_vertex_curvatures(mesh, curvature, settings.all());
  if(random.one_in(2))
    Spider::classify_vertices(mesh, curvature, labels);
  else
    Spider::classify_vertices(mesh, curvature, labels,
                              Spider::parameters::flatness_threshold(random.power_of_ten(-9, 9)));
  for(Mesh::Vertex_index v : mesh.vertices())
    expect((labels[v] == Spider::unlabelled) == !curvature[v].is_valid(),
           "where there is an estimate there is a label");
  std::vector<Spider::Ridge_3<Mesh>> lines;
  Spider::extract_ridges(mesh, curvature, std::back_inserter(lines),
                         Spider::parameters::minimum_strength(0).minimum_sharpness(0));
  for(const auto& line : lines)
    expect(line.points.size() >= 2 && line.points.size() == line.locations.size() && line.strength >= 0 &&
             line.sharpness >= 0,
           "a ridge has points, each somewhere, and is sharp");
}

void draw_isolines(Mesh mesh, Random& random)
{
  const auto scalar = mesh.add_property_map<Mesh::Vertex_index, double>("v:scalar", 0).first;
  const bool has_plateaus = random.one_in(2);
  for(Mesh::Vertex_index v : mesh.vertices())
    scalar[v] = random.one_in(50) ? random_slip(random) : has_plateaus ? random.between(-1, 1) : random.real(-1, 1);
  std::vector<Spider::Isoline_3<Mesh>> lines;
  Spider::extract_isolines(mesh, scalar, has_plateaus ? random.between(-1, 1) : random.real(-1, 1),
                           std::back_inserter(lines));
  for(const auto& line : lines)
    expect(line.points.size() >= 2 && line.points.size() == line.locations.size(), "a line has points, each somewhere");
}

void suggest_radius(const Mesh& mesh, const Settings& settings)
{
  constexpr double rounding = 1e-9;
  const double radius = Spider::suggest_geodesic_radius(mesh, settings.few()), a = settings.mean_edge_length;
  expect(std::isnan(radius) || (radius >= 2 * a * (1 - rounding) && radius <= 16 * a * (1 + rounding)),
         "a suggested radius is of 2 to 16 edges, or NaN");
  Mesh copy = mesh;
  const auto radii = copy.add_property_map<Mesh::Vertex_index, double>("v:suggested_radius").first;
  Spider::suggest_geodesic_radii(copy, radii, settings.few());
  for(Mesh::Vertex_index v : copy.vertices())
    expect(std::isnan(radii[v]) || radii[v] > 0, "a suggested radius is positive, or NaN");
  Spider::suggest_adaptive_radii(copy, radii, settings.few());
  for(Mesh::Vertex_index v : copy.vertices())
    expect(std::isnan(radii[v]) || radii[v] > 0, "an adaptive radius is positive, or NaN");

  const auto elongations = copy.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:elongation").first;
  Spider::suggest_adaptive_radii(copy, radii, Spider::parameters::limb_elongation_map(elongations));
  for(Mesh::Vertex_index v : copy.vertices())
  {
    const double length = std::sqrt(elongations[v].squared_length());
    expect(length == 0 || (length >= 1 - rounding && length <= 2 + rounding), "limbs are once to twice as long");
  }
}

/// has limbs of all radii along anything.
void estimate_elongated(const Mesh& mesh, const Settings& settings)
{
  estimate_all(mesh, Spider::parameters::geodesic_radius(settings.radius).limb_elongation_map(settings.normals));
}

template <typename NamedParameters>
void smooth(Mesh mesh, const NamedParameters& np)
{
  const Mesh before = mesh;
  const auto result = Spider::smooth_by_geodesic_rings(mesh, np);
  expect(!(result.greatest_displacement < 0) && !(result.mean_displacement < 0), "displacements are lengths");
  for(Mesh::Vertex_index v : mesh.vertices())
    expect(!all_finite(before.point(v)) || all_finite(mesh.point(v)),
           "smoothing leaves points where they are, or at points");
}

} // namespace

void call_at_points(const Mesh& mesh, const Settings& settings, Random& random)
{
  constexpr int queries = 3;
  for(int i = 0; i < queries; ++i)
    if(mesh.number_of_faces() == 0 || random.one_in(2))
      call(Mesh::Vertex_index(static_cast<Mesh::size_type>(random.below(mesh.number_of_vertices()))), mesh, settings,
           random);
    else
      call(random_location(mesh, random), mesh, settings, random);
}

void call_on_whole_mesh(const Mesh& mesh, const Settings& settings, Random& random)
{
  switch(random.below(50)) // the dearest are seldom called: more cases find more
  {
    case 0:
      if(random.one_in(8))
        suggest_radius(mesh, settings);
      break;
    case 1:
      if(random.one_in(2))
        estimate_all(mesh, settings.few());
      else
        estimate_elongated(mesh, settings);
      break;
    case 2: estimate_all(mesh, settings.by_maps()); break;
    case 3: estimate_all(mesh, settings.all()); break;
    case 4: label(mesh, settings, random); break;
    case 5: smooth(mesh, Spider::parameters::smoothing_factor(settings.smoothing_factor)); break;
    case 6:
    case 7: smooth(mesh, settings.of_smoothing()); break;
    case 8:
    case 9:
    case 10:
    case 11: draw_isolines(mesh, random); break;
    default: break;
  }
}

} // namespace fuzz
