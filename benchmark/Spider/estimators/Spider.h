// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_ESTIMATORS_SPIDER_H
#define CGAL_SPIDER_BENCHMARK_ESTIMATORS_SPIDER_H

#include "../Estimator.h"

#include <CGAL/Spider/estimate_vertex_curvatures.h>

#include <string>
#include <utility>

namespace CGAL {
namespace Spider {
namespace benchmark {

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
    std::vector<Curvature_estimate_3<Kernel>> found(mesh.num_vertices());
    const auto map = boost::make_iterator_property_map(found.begin(), get(boost::vertex_index, mesh));
    estimate_vertex_curvatures(mesh, map, m_np.geodesic_radius(radius));

    out.clear();
    out.reserve(found.size());
    for(const auto& f : found)
      out.push_back({f.min_curvature, f.max_curvature, f.min_direction, f.max_direction, f.normal});
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
