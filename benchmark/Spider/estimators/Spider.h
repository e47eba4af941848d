// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_ESTIMATORS_SPIDER_H
#define CGAL_SPIDER_BENCHMARK_ESTIMATORS_SPIDER_H

#include "../Estimator.h"

#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/suggest_adaptive_radii.h>
#include <CGAL/Spider/suggest_geodesic_radius.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

template <typename NamedParameters>
void estimate_by_spider(const Mesh& mesh, const NamedParameters& np, std::vector<Estimate>& out)
{
  std::vector<Curvature_estimate_3<Kernel>> found(mesh.num_vertices());
  estimate_vertex_curvatures(mesh, boost::make_iterator_property_map(found.begin(), get(boost::vertex_index, mesh)),
                             np);

  out.clear();
  out.reserve(found.size());
  for(const auto& f : found)
    out.push_back({f.min_curvature, f.max_curvature, f.min_direction, f.max_direction, f.normal});
}

// Spider with the given named parameters, to which the radius is added.
template <typename NamedParameters>
class Spider_estimator : public Estimator
{
public:
  Spider_estimator(std::string name, std::string settings, const NamedParameters& np)
    : m_name(std::move(name)), m_settings(std::move(settings)), m_np(np)
  {}

  std::string name() const override { return m_name; }
  std::string settings() const override { return m_settings; }

  void estimate(const Mesh& mesh, double radius, std::vector<Estimate>& out) const override
  {
    estimate_by_spider(mesh, m_np.geodesic_radius(radius), out);
  }

private:
  std::string m_name, m_settings;
  NamedParameters m_np;
};

template <typename NamedParameters>
std::unique_ptr<Estimator> make_spider(std::string name, std::string settings, const NamedParameters& np)
{
  return std::make_unique<Spider_estimator<NamedParameters>>(std::move(name), std::move(settings), np);
}

// surface_fit, all else the library's defaults
inline std::unique_ptr<Estimator> spider(unsigned int degree)
{
  return make_spider(degree == 2 ? "spider" : "spider_d" + std::to_string(degree),
                     "Spider's surface_fit with the library's defaults: one height field of degree " +
                       std::to_string(degree) +
                       " for the samples of all limbs of tangential distance r, first normals "
                       "averaged over a neighbourhood",
                     parameters::estimator(surface_fit).polynomial_degree(degree));
}

// The library's defaults at the radii that it suggests for the vertices of a mesh, not at the one that is given.
class Spider_at_suggested_radii : public Estimator
{
public:
  using Radii = std::vector<double>;
  using Suggestion = Radii (*)(const Mesh&);

  Spider_at_suggested_radii(std::string name, std::string function, Suggestion suggestion)
    : m_name(std::move(name)), m_function(std::move(function)), m_suggestion(suggestion)
  {}

  std::string name() const override { return m_name; }
  std::string settings() const override
  {
    return "Spider's surface_fit with the library's defaults at what " + m_function + "() suggests";
  }
  bool uses_radius() const override { return false; }

  void estimate(const Mesh& mesh, double, std::vector<Estimate>& out) const override
  {
    const Radii radii = m_suggestion(mesh);
    const auto map = boost::make_iterator_property_map(radii.begin(), get(boost::vertex_index, mesh));
    estimate_by_spider(mesh, parameters::geodesic_radius(map), out);
  }

private:
  std::string m_name, m_function;
  Suggestion m_suggestion;
};

inline std::unique_ptr<Estimator> spider_at_suggested_radius()
{
  return std::make_unique<Spider_at_suggested_radii>(
    "spider_suggested", "suggest_geodesic_radius",
    [](const Mesh& mesh) { return std::vector<double>(mesh.num_vertices(), suggest_geodesic_radius(mesh)); });
}

inline std::unique_ptr<Estimator> spider_at_adaptive_radii()
{
  return std::make_unique<Spider_at_suggested_radii>("spider_adaptive", "suggest_adaptive_radii", [](const Mesh& mesh) {
    std::vector<double> radii(mesh.num_vertices());
    suggest_adaptive_radii(mesh, boost::make_iterator_property_map(radii.begin(), get(boost::vertex_index, mesh)));
    return radii;
  });
}

class Spider_with_adaptive_limbs : public Estimator
{
public:
  std::string name() const override { return "spider_adaptive_limbs"; }
  std::string settings() const override
  {
    return "Spider's surface_fit with the library's defaults, radii and elongations as suggest_adaptive_radii() "
           "suggests";
  }
  bool uses_radius() const override { return false; }

  void estimate(const Mesh& mesh, double, std::vector<Estimate>& out) const override
  {
    std::vector<double> radii(mesh.num_vertices());
    std::vector<Kernel::Vector_3> elongations(mesh.num_vertices());
    const auto index = get(boost::vertex_index, mesh);
    const auto radius_map = boost::make_iterator_property_map(radii.begin(), index);
    const auto elongation_map = boost::make_iterator_property_map(elongations.begin(), index);
    suggest_adaptive_radii(mesh, radius_map, parameters::limb_elongation_map(elongation_map));
    estimate_by_spider(mesh, parameters::geodesic_radius(radius_map).limb_elongation_map(elongation_map), out);
  }
};

inline std::unique_ptr<Estimator> spider_as_published()
{
  return make_spider("spider_published",
                     "Spider's section_fit: 64 directions, quadratics, limbs of arc length r, up to ten rounds, first "
                     "normals from the section with a sphere of radius r: the paper's settings",
                     parameters::as_published());
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_ESTIMATORS_SPIDER_H
