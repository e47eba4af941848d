// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What every public function says of a mesh, in numbers that don't depend on how the mesh is stored, so that those of
// any two types of meshes and kernels can be compared.

#ifndef CGAL_SPIDER_TEST_EVERY_FUNCTION_H
#define CGAL_SPIDER_TEST_EVERY_FUNCTION_H

#include "meshes.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Spider.h>

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace every_function {

namespace Spider = CGAL::Spider;
namespace params = CGAL::Spider::parameters;

using meshes::Vector;

/// a function's name and what it says. Lengths should be around 1, since comparison is by absolute differences, too.
using Answer = std::pair<std::string, std::vector<double>>;

inline void add(std::vector<double>& numbers, double x) { numbers.push_back(x); }

inline void add(std::vector<double>& numbers, const Vector& a) { numbers.insert(numbers.end(), {a.x(), a.y(), a.z()}); }

template <typename GT>
void add(std::vector<double>& numbers, const Spider::Curvature_estimate_3<GT>& e)
{
  numbers.insert(numbers.end(), {double(e.min_curvature), double(e.max_curvature), double(e.status), double(e.coverage),
                                 double(e.residual)});
  add(numbers, meshes::vector(e.normal));
}

template <typename Points>
double length_of(const Points& points)
{
  double sum = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    sum += (meshes::vector(points[i]) - meshes::vector(points[i - 1])).norm();
  return sum;
}

template <typename Mesh>
class Caller
{
public:
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using FT = typename CGAL::Kernel_traits<meshes::Point_of<Mesh>>::Kernel::FT;
  using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, FT>;
  using Normal = decltype(Spider::estimate_normal(std::declval<Vertex>(), std::declval<const Mesh&>()));
  using Estimate = decltype(Spider::estimate_curvature(std::declval<Vertex>(), std::declval<const Mesh&>()));

  Caller(Mesh& mesh, double radius)
    : mesh_(mesh), radius_(radius), vertices_(vertices(mesh).begin(), vertices(mesh).end())
  {
    std::sort(vertices_.begin(), vertices_.end(),
              [&](Vertex a, Vertex b) { return place(meshes::point(mesh, a)) < place(meshes::point(mesh, b)); });
  }

  /// calls every function; the last one moves the vertices.
  std::vector<Answer> operator()()
  {
    const Vertex v = vertices_[vertices_.size() / 2];
    ask_at(v, "vertex");
    ask_at(face_centre(v), "face");
    ask_everywhere();
    suggest();
    smooth();
    return std::move(answers_);
  }

private:
  using Place = std::array<double, 3>;
  static Place place(const Vector& p) { return {p.x(), p.y(), p.z()}; }

  /// returns the centre of one of the faces around a vertex.
  Location face_centre(Vertex v) const
  {
    const FT third = FT(1) / FT(3);
    std::map<Place, Location> centres;
    for(auto f : CGAL::faces_around_target(halfedge(v, mesh_), mesh_))
      if(f != boost::graph_traits<Mesh>::null_face())
      {
        Vector sum(0, 0, 0);
        std::vector<Vector> corners;
        for(Vertex corner : CGAL::vertices_around_face(halfedge(f, mesh_), mesh_))
          corners.push_back(meshes::point(mesh_, corner));
        std::sort(corners.begin(), corners.end(), [](const Vector& a, const Vector& b) { return place(a) < place(b); });
        for(const Vector& p : corners)
          sum += p;
        centres.emplace(place(sum), Location(f, {third, third, third}));
      }
    return centres.begin()->second;
  }

  std::vector<double>& answer(const std::string& name)
  {
    answers_.emplace_back(name, std::vector<double>());
    return answers_.back().second;
  }

  auto np() const { return params::geodesic_radius(radius_).number_of_directions(16); }

  template <typename Query>
  void ask_at(const Query& query, const std::string& where)
  {
    const Normal normal = Spider::estimate_normal(query, mesh_, np());
    const Normal direction = CGAL::cross_product(normal, Normal(1, 2, 3));
    add(answer("estimate_normal, " + where), meshes::vector(normal));

    const auto limb = Spider::trace_limb(query, normal, direction, mesh_, np());
    add(answer("trace_limb, " + where), double(limb.end));
    add(answers_.back().second, double(limb.length));
    auto& samples = answer("resample, " + where);
    for(const auto& p : Spider::resample(limb, limb.length / 7.5))
      add(samples, meshes::vector(p));

    std::vector<Spider::Limb_3<Mesh>> limbs;
    Spider::trace_limbs(query, normal, mesh_, std::back_inserter(limbs), np());
    auto& ends = answer("trace_limbs, " + where);
    for(const auto& each : limbs)
      add(ends, meshes::vector(each.polyline.back()));
    std::vector<typename Spider::Limb_3<Mesh>::Point_3> ring;
    Spider::geodesic_ring(query, normal, mesh_, std::back_inserter(ring), np());
    auto& ring_points = answer("geodesic_ring, " + where);
    for(const auto& p : ring)
      add(ring_points, meshes::vector(p));
    auto& section = answer("trace_sphere_section, " + where);
    for(const auto& polyline : Spider::trace_sphere_section(query, mesh_, np()))
      add(section, length_of(polyline));

    const auto along = Spider::estimate_normal_curvature(query, normal, direction, mesh_, np());
    answer("estimate_normal_curvature, " + where) = {double(along.curvature), double(along.tangent_slope),
                                                     double(along.residual), double(along.status)};
    add(answer("estimate_curvature, " + where), Spider::estimate_curvature(query, mesh_, np()));
    const auto own = np();
    const Spider::Curvature_estimator<Mesh, std::decay_t<decltype(own)>> estimator(mesh_, own);
    add(answer("Curvature_estimator, " + where), estimator(query));
  }

  void ask_everywhere()
  {
    std::map<Vertex, Normal> normals;
    Spider::estimate_vertex_normals(mesh_, boost::make_assoc_property_map(normals), np());
    std::vector<Estimate> estimates;
    Spider::estimate_curvatures(vertices_, mesh_, std::back_inserter(estimates), np());
    std::map<Vertex, Estimate> curvature;
    const auto curvature_map = boost::make_assoc_property_map(curvature);
    Spider::estimate_vertex_curvatures(mesh_, curvature_map, np());
    std::map<Vertex, Spider::Vertex_label> labels;
    const double threshold =
      double(Spider::classify_vertices(mesh_, curvature_map, boost::make_assoc_property_map(labels)));

    for(Vertex v : vertices_)
      add(find("estimate_vertex_normals"), meshes::vector(normals[v]));
    for(const Estimate& e : estimates)
      add(find("estimate_curvatures"), e);
    for(Vertex v : vertices_)
      add(find("estimate_vertex_curvatures"), curvature[v]);
    add(find("classify_vertices"), threshold);
    for(Vertex v : vertices_)
      add(find("classify_vertices"), double(labels[v]));
    const auto radial =
      Spider::radial_curvature_field(curvature_map, get(CGAL::vertex_point, mesh_), meshes::Point_of<Mesh>(9, 8, 7));
    for(Vertex v : vertices_)
      add(find("radial_curvature_field"), double(get(radial, v)));
    extract_lines(curvature_map);
  }

  template <typename CurvatureMap>
  void extract_lines(CurvatureMap curvature_map)
  {
    const auto mean_curvature = Spider::derived_field(curvature_map, Spider::Mean_curvature());
    std::vector<double> values;
    for(Vertex v : vertices_)
      values.push_back(double(get(mean_curvature, v)));
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    std::vector<Spider::Isoline_3<Mesh>> isolines;
    Spider::extract_isolines(mesh_, mean_curvature, values[values.size() / 2] * 1.01, std::back_inserter(isolines));
    add_lines(answer("extract_isolines"), isolines, [](const auto&) { return 0.; });
    std::vector<Spider::Ridge_3<Mesh>> ridges;
    Spider::extract_ridges(mesh_, curvature_map, std::back_inserter(ridges),
                           params::geodesic_radius(radius_).minimum_strength(0).minimum_sharpness(0));
    add_lines(answer("extract_ridges"), ridges, [](const auto& line) { return double(line.strength); });
  }

  /// adds what tells lines apart, in the order of their lengths.
  template <typename Lines, typename Strength>
  static void add_lines(std::vector<double>& numbers, const Lines& lines, Strength&& strength)
  {
    std::vector<std::array<double, 4>> found;
    for(const auto& line : lines)
      found.push_back({length_of(line.points), double(line.points.size()), double(line.is_closed), strength(line)});
    std::sort(found.begin(), found.end());
    for(const auto& line : found)
      numbers.insert(numbers.end(), line.begin(), line.end());
  }

  void suggest()
  {
    add(answer("suggest_geodesic_radius"), double(Spider::suggest_geodesic_radius(mesh_)));
    std::map<Vertex, double> radii;
    Spider::suggest_geodesic_radii(mesh_, boost::make_assoc_property_map(radii));
    auto& numbers = answer("suggest_geodesic_radii");
    for(Vertex v : vertices_)
      add(numbers, radii[v]);
    Spider::suggest_adaptive_radii(mesh_, boost::make_assoc_property_map(radii));
    auto& adaptive = answer("suggest_adaptive_radii");
    for(Vertex v : vertices_)
      add(adaptive, radii[v]);
  }

  void smooth()
  {
    const auto result = Spider::smooth_by_geodesic_rings(mesh_, params::smoothing_factor(0.5));
    auto& numbers = answer("smooth_by_geodesic_rings");
    numbers = {double(result.number_of_iterations), double(result.greatest_displacement),
               double(result.mean_displacement), double(result.volume_before), double(result.volume_after)};
    for(Vertex v : vertices_)
      add(numbers, meshes::point(mesh_, v));
  }

  std::vector<double>& find(const std::string& name)
  {
    const auto found = std::find_if(answers_.begin(), answers_.end(), [&](const Answer& a) { return a.first == name; });
    return found == answers_.end() ? answer(name) : found->second;
  }

  Mesh& mesh_;
  double radius_;
  std::vector<Vertex> vertices_; ///< in the order of their places
  std::vector<Answer> answers_;
};

/// returns what every function says of a mesh, the vertices of which are moved in the end.
template <typename Mesh>
std::vector<Answer> call(Mesh& mesh, double radius)
{
  return Caller<Mesh>(mesh, radius)();
}

/// expects the same numbers: NaN where there is NaN, else up to `tolerance` relative to 1 or to what is larger.
inline void expect_same(const std::vector<Answer>& got, const std::vector<Answer>& expected, double tolerance)
{
  ASSERT_EQ(got.size(), expected.size());
  for(std::size_t i = 0; i < got.size(); ++i)
  {
    SCOPED_TRACE(expected[i].first);
    const std::vector<double>&a = got[i].second, &b = expected[i].second;
    EXPECT_FALSE(b.empty());
    ASSERT_EQ(a.size(), b.size());
    for(std::size_t j = 0; j < a.size(); ++j)
      if(!std::isnan(a[j]) || !std::isnan(b[j]))
      {
        EXPECT_NEAR(a[j], b[j], tolerance * std::max(1., std::abs(b[j]))) << j;
      }
  }
}

} // namespace every_function

#endif // CGAL_SPIDER_TEST_EVERY_FUNCTION_H
