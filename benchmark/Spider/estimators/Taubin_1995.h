// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_TAUBIN_1995_H
#define CGAL_SPIDER_BENCHMARK_TAUBIN_1995_H

#include "shared/tangent_tensor.h"

namespace CGAL {
namespace Spider {
namespace benchmark {

// Taubin, "Estimating the tensor of curvature of a surface from a polyhedral approximation", 1995.
//   normal                    the faces' normals averaged by area
//   M = sum w k T T'          T the edge's direction in the tangent plane, k = 2 n.(x_j - x_i) / |x_j - x_i|^2, w the
//   area
//                             of the faces at the edge over the sum of those areas: the paper's discrete form of the
//                             integral of k T T' over the directions
//   principal curvatures      3 m1 - m2 and 3 m2 - m1 from the eigenvalues m1, m2 of M; directions are M's eigenvectors
// The paper finds M's tangent eigenvectors by a Householder reflection and a Givens rotation; here M is built in the
// tangent plane at once, which is the same. At a border vertex the sum runs over the edges that there are.
class Taubin_1995 : public Estimator
{
public:
  std::string name() const override { return "taubin"; }
  std::string settings() const override { return "Taubin 1995, one-ring, area-weighted normals"; }
  bool uses_radius() const override { return false; }

  void estimate(const Mesh& mesh, double /*radius*/, std::vector<Estimate>& out) const override
  {
    const std::vector<Vector> normals = vertex_normals(mesh, Normal_weight::area);
    std::vector<Tangent_tensor> sums(mesh.num_vertices());
    std::vector<double> weights(mesh.num_vertices(), 0);
    for(Mesh::Face_index f : mesh.faces())
    {
      const Face_geometry face(mesh, f);
      for(int i = 0; i < 3; ++i)
      {
        // each face gives its area to both of the corner's edges, so that an edge gets both of its faces' areas
        const std::size_t v = face.vertices[i].idx();
        const Tangent_frame frame(normals[v]);
        for(const Vector& edge : {face.sides[previous_corner(i)], -face.sides[next_corner(i)]})
        {
          sums[v] += directed_curvature(frame, edge) * face.area();
          weights[v] += face.area();
        }
      }
    }
    out.assign(mesh.num_vertices(), Estimate());
    for(Mesh::Vertex_index v : mesh.vertices())
      out[v.idx()] =
        principal_estimate(Tangent_frame(normals[v.idx()]), tensor(sums[v.idx()] * (1 / weights[v.idx()])));
  }

private:
  // k T T', k being positive where the surface bends away from the normal
  static Tangent_tensor directed_curvature(const Tangent_frame& frame, const Vector& edge)
  {
    const double x = edge * frame.u, y = edge * frame.v, squared = x * x + y * y;
    if(squared == 0)
      return {}; // the edge is along the normal: it has no direction
    const double curvature = -2 * (edge * frame.normal) / edge.squared_length();
    return Tangent_tensor{x * x, x * y, y * y} * (curvature / squared);
  }

  // 4 M - trace(M) I has M's eigenvectors, and 3 m1 - m2, 3 m2 - m1 for eigenvalues
  static Tangent_tensor tensor(const Tangent_tensor& m) { return {3 * m.uu - m.vv, 4 * m.uv, 3 * m.vv - m.uu}; }
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_TAUBIN_1995_H
