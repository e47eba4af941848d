// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_GOLDFEATHER_INTERRANTE_2004_H
#define CGAL_SPIDER_BENCHMARK_GOLDFEATHER_INTERRANTE_2004_H

#include "shared/Vertex_gatherer.h"
#include "shared/tangent_tensor.h"

#include <Eigen/QR>

namespace CGAL {
namespace Spider {
namespace benchmark {

// Goldfeather and Interrante, "A novel cubic-order algorithm for approximating principal direction vectors", 2004, the
// adjacent-normal cubic approximation: in coordinates with the vertex as origin and its normal as z-axis,
//   f(x, y) = A/2 x^2 + B x y + C/2 y^2 + D x^3 + E x^2 y + F x y^2 + G y^3
// is fitted by least squares to three equations per neighbour (x, y, z) with normal (a, b, c):
//   f = z
//   df/dx = A x + B y + 3 D x^2 + 2 E x y + F y^2 = -a/c
//   df/dy = B x + C y + E x^2 + 2 F x y + 3 G y^2 = -b/c
// and (A B; B C) is the Weingarten matrix. Lengths are first divided by the neighbours' root mean square distance:
// without a unit, the first equation's weight against the other two, and so the answer, would depend on the mesh's.
// The paper leaves open how the vertices' normals are averaged. By the weights of Max 1999 they are exact on a sphere
// and of second order elsewhere, and so are the curvatures; by area they are of first order on irregular meshes, and
// curvatures get worse the smaller the ball, but under noise they are better by a fifth or more: a ball comes with
// either. A neighbour whose normal has turned by a right angle or more has no slope and is left out.
class Goldfeather_Interrante_2004 : public Estimator
{
public:
  enum class Neighbourhood
  {
    one_ring, // the paper's
    ball      // all connected vertices within the radius: the better case under noise
  };

  explicit Goldfeather_Interrante_2004(Neighbourhood neighbourhood, Normal_weight weight = Normal_weight::sphere)
    : m_neighbourhood(neighbourhood), m_weight(weight)
  {}

  std::string name() const override
  {
    return std::string("goldfeather") + (uses_radius() ? "_ball" : "") +
           (m_weight == Normal_weight::area ? "_area" : "");
  }

  std::string settings() const override
  {
    return std::string("Goldfeather and Interrante 2004, cubic fit to positions and normals, ") +
           (uses_radius() ? "all connected vertices within r, " : "one-ring, ") +
           (m_weight == Normal_weight::area ? "area-weighted vertex normals"
                                            : "vertex normals by the weights of Max 1999");
  }

  bool uses_radius() const override { return m_neighbourhood == Neighbourhood::ball; }

  void estimate(const Mesh& mesh, double radius, std::vector<Estimate>& out) const override
  {
    estimate_from_normals(mesh, vertex_normals(mesh, m_weight), radius, out);
  }

  // the same from given unit normals, by vertex index
  void estimate_from_normals(const Mesh& mesh, const std::vector<Vector>& normals, double radius,
                             std::vector<Estimate>& out) const
  {
    out.assign(mesh.num_vertices(), Estimate());
    Vertex_gatherer gatherer(mesh);
    Fit fit;
    for(Mesh::Vertex_index v : mesh.vertices())
    {
      if(!is_finite(normals[v.idx()]))
        continue;
      const auto& vertices = uses_radius() ? gatherer.ball(v, radius, 1 + fewest_neighbours) : gatherer.rings(v, 2);
      const Tangent_frame frame(normals[v.idx()]);
      out[v.idx()] = principal_estimate(frame, fit(mesh, vertices, frame, normals));
    }
  }

private:
  static constexpr Eigen::Index number_of_unknowns = 7;
  static constexpr Eigen::Index rows_per_neighbour = 3;
  static constexpr std::size_t fewest_neighbours = 3; // nine equations for seven unknowns

  // Keeps its matrices from vertex to vertex.
  class Fit
  {
  public:
    Tangent_tensor operator()(const Mesh& mesh, const Vertex_gatherer::Vertices& vertices, const Tangent_frame& frame,
                              const std::vector<Vector>& normals)
    {
      constexpr Tangent_tensor none{Estimate::nan, Estimate::nan, Estimate::nan};
      const double scale = root_mean_square_distance(mesh, vertices);
      m_matrix.resize(rows_per_neighbour * vertices.size(), number_of_unknowns);
      m_right.resize(rows_per_neighbour * vertices.size());
      m_rows = 0;
      for(std::size_t i = 1; i < vertices.size(); ++i)
        add(frame, (mesh.point(vertices[i]) - mesh.point(vertices[0])) / scale, normals[vertices[i].idx()]);
      if(m_rows < number_of_unknowns)
        return none;
      m_qr.compute(m_matrix.topRows(m_rows));
      if(m_qr.rank() < number_of_unknowns)
        return none;
      const Eigen::Matrix<double, number_of_unknowns, 1> solution = m_qr.solve(m_right.head(m_rows));
      // f is concave where the surface bends away from the normal
      return Tangent_tensor{solution[0], solution[1], solution[2]} * (-1 / scale);
    }

  private:
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, number_of_unknowns>;

    static double root_mean_square_distance(const Mesh& mesh, const Vertex_gatherer::Vertices& vertices)
    {
      double sum = 0;
      for(Mesh::Vertex_index v : vertices)
        sum += (mesh.point(v) - mesh.point(vertices[0])).squared_length();
      return std::sqrt(sum / (std::max)(std::size_t(1), vertices.size() - 1));
    }

    void add(const Tangent_frame& frame, const Vector& position, const Vector& normal)
    {
      const double x = position * frame.u, y = position * frame.v, z = position * frame.normal;
      const double a = normal * frame.u, b = normal * frame.v, c = normal * frame.normal;
      if(!(c > 0) || !std::isfinite(x + y + z))
        return;
      m_matrix.row(m_rows) << x * x / 2, x * y, y * y / 2, x * x * x, x * x * y, x * y * y, y * y * y;
      m_right[m_rows++] = z;
      m_matrix.row(m_rows) << x, y, 0, 3 * x * x, 2 * x * y, y * y, 0;
      m_right[m_rows++] = -a / c;
      m_matrix.row(m_rows) << 0, x, y, 0, x * x, 2 * x * y, 3 * y * y;
      m_right[m_rows++] = -b / c;
    }

    Matrix m_matrix;
    Eigen::VectorXd m_right;
    Eigen::Index m_rows = 0;
    Eigen::ColPivHouseholderQR<Matrix> m_qr;
  };

  Neighbourhood m_neighbourhood;
  Normal_weight m_weight;
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_GOLDFEATHER_INTERRANTE_2004_H
