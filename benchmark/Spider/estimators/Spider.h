// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_ESTIMATORS_SPIDER_H
#define CGAL_SPIDER_BENCHMARK_ESTIMATORS_SPIDER_H

#include "../Estimator.h"

#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/suggest_adaptive_radii.h>
#include <CGAL/Spider/suggest_geodesic_radius.h>

#include <cmath>
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

// The library's defaults at the radius that it suggests, not at the one that is given.
class Spider_at_suggested_radius : public Estimator
{
public:
  std::string name() const override { return "spider_suggested"; }
  std::string settings() const override
  {
    return "Spider's surface_fit with the library's defaults at the radius that suggest_geodesic_radius() tells";
  }
  bool uses_radius() const override { return false; }

  void estimate(const Mesh& mesh, double, std::vector<Estimate>& out) const override
  {
    const double suggested = suggest_geodesic_radius(mesh);
    out.assign(mesh.num_vertices(), Estimate());
    if(!std::isnan(suggested)) // as it is for a mesh without faces
      estimate_by_spider(mesh, parameters::geodesic_radius(suggested), out);
  }
};

// The same at a radius of each vertex's own.
class Spider_at_adaptive_radii : public Estimator
{
public:
  std::string name() const override { return "spider_adaptive"; }
  std::string settings() const override
  {
    return "Spider's surface_fit with the library's defaults at the radii that suggest_adaptive_radii() tells";
  }
  bool uses_radius() const override { return false; }

  void estimate(const Mesh& mesh, double, std::vector<Estimate>& out) const override
  {
    std::vector<double> radii(mesh.num_vertices());
    const auto map = boost::make_iterator_property_map(radii.begin(), get(boost::vertex_index, mesh));
    suggest_adaptive_radii(mesh, map);
    estimate_by_spider(mesh, parameters::geodesic_radius(map), out);
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
