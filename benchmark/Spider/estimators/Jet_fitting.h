// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_JET_FITTING_H
#define CGAL_SPIDER_BENCHMARK_JET_FITTING_H

#include "shared/Vertex_gatherer.h"
#include "shared/vertex_normals.h"

#include <CGAL/Monge_via_jet_fitting.h>

namespace CGAL {
namespace Spider {
namespace benchmark {

// Cazals and Pouget, "Estimating differential quantities using polynomial fitting of osculating jets", 2003 (CAGD
// 2005), through CGAL's own implementation, `Monge_via_jet_fitting`: nothing of the method is written here. As in
// CGAL's example Mesh_estimation.cpp, the vertex is the first of the points, the Monge form is of degree 2, and is
// turned by `comply_wrt_given_normal` to the side of the mesh's normal; a jet of degree d needs (d + 1)(d + 2) / 2
// points. CGAL's curvatures are negative on a sphere with outward normals; here they change sign, and with it order.
class Jet_fitting : public Estimator
{
public:
  enum class Neighbourhood
  {
    rings, // the example's default: the fewest whole rings that give enough points
    ball   // all connected vertices within the radius, which grows where they are too few
  };

  Jet_fitting(std::size_t degree, Neighbourhood neighbourhood) : m_degree(degree), m_neighbourhood(neighbourhood) {}

  std::string name() const override { return "jet" + std::to_string(m_degree) + (uses_radius() ? "_ball" : "_rings"); }

  std::string settings() const override
  {
    return "CGAL::Monge_via_jet_fitting, jet of degree " + std::to_string(m_degree) + ", Monge form of degree 2, " +
           (uses_radius() ? "all connected vertices within r (r grows where they are fewer than "
                          : "the fewest whole rings (that give ") +
           std::to_string(number_of_coefficients()) + " points), turned to the area-weighted vertex normal";
  }

  bool uses_radius() const override { return m_neighbourhood == Neighbourhood::ball; }

  void estimate(const Mesh& mesh, double radius, std::vector<Estimate>& out) const override
  {
    out.assign(mesh.num_vertices(), Estimate());
    const std::vector<Vector> normals = vertex_normals(mesh, Normal_weight::area);
    Vertex_gatherer gatherer(mesh);
    std::vector<Point> points;
    for(Mesh::Vertex_index v : mesh.vertices())
    {
      const auto& vertices = uses_radius() ? gatherer.ball(v, radius, number_of_coefficients())
                                           : gatherer.rings(v, number_of_coefficients());
      points.clear();
      for(Mesh::Vertex_index w : vertices)
        points.push_back(mesh.point(w));
      if(points.size() >= number_of_coefficients() && is_finite(normals[v.idx()]))
        out[v.idx()] = fit(points, normals[v.idx()]);
    }
  }

private:
  using Fitting = CGAL::Monge_via_jet_fitting<Kernel>;

  std::size_t number_of_coefficients() const { return (m_degree + 1) * (m_degree + 2) / 2; }

  Estimate fit(const std::vector<Point>& points, const Vector& normal) const
  {
    constexpr std::size_t monge_degree = 2; // curvatures and directions need no more
    Fitting fitting;
    Fitting::Monge_form form = fitting(points.begin(), points.end(), m_degree, monge_degree);
    form.comply_wrt_given_normal(normal);

    Estimate estimate;
    if(!std::isfinite(form.principal_curvatures(0)) || !std::isfinite(form.principal_curvatures(1)))
      return estimate;
    estimate.min_curvature = -form.principal_curvatures(0);
    estimate.max_curvature = -form.principal_curvatures(1);
    estimate.min_direction = form.maximal_principal_direction();
    estimate.max_direction = form.minimal_principal_direction();
    estimate.normal = form.normal_direction();
    return estimate;
  }

  std::size_t m_degree;
  Neighbourhood m_neighbourhood;
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_JET_FITTING_H
