// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_RUSINKIEWICZ_2004_H
#define CGAL_SPIDER_BENCHMARK_RUSINKIEWICZ_2004_H

#include "shared/tangent_tensor.h"

#include <Eigen/Cholesky>

namespace CGAL {
namespace Spider {
namespace benchmark {

// Rusinkiewicz, "Estimating curvatures and their derivatives on triangle meshes", 2004.
//   vertex normals            the weights of Max 1999, which the paper recommends
//   tensor of a face          II, in the face's plane, that takes each side to the difference of the normals at its
//   ends,
//                             by least squares over the three sides (six equations, three unknowns)
//   at a vertex               the vertex's tangent plane rotated onto the face's, so that II is not foreshortened, then
//                             the average over the faces
//   weights                   the part of the face that is nearest to the vertex
class Rusinkiewicz_2004 : public Estimator
{
public:
  std::string name() const override { return "rusinkiewicz"; }

  std::string settings() const override
  {
    return "Rusinkiewicz 2004, one-ring, vertex normals by the weights of Max 1999, no diffusion";
  }

  bool uses_radius() const override { return false; }

  void estimate(const Mesh& mesh, double /*radius*/, std::vector<Estimate>& out) const override
  {
    estimate_from_normals(mesh, vertex_normals(mesh, Normal_weight::sphere), out);
  }

  // the same from given unit normals, by vertex index
  void estimate_from_normals(const Mesh& mesh, const std::vector<Vector>& normals, std::vector<Estimate>& out) const
  {
    std::vector<Tangent_tensor> sums(mesh.num_vertices());
    std::vector<double> weights(mesh.num_vertices(), 0);
    for(Mesh::Face_index f : mesh.faces())
    {
      const Face_geometry face(mesh, f);
      if(!(face.doubled_area > 0))
        continue; // no plane, and no weight either
      const Tangent_frame frame = frame_along_first_side(face);
      const Tangent_tensor face_tensor = fit(face, frame, normals);
      const std::array<double, 3> areas = face.nearest_areas();
      for(int i = 0; i < 3; ++i)
      {
        const std::size_t v = face.vertices[i].idx();
        sums[v] += rotated(face_tensor, frame, Tangent_frame(normals[v])) * areas[i];
        weights[v] += areas[i];
      }
    }
    out.assign(mesh.num_vertices(), Estimate());
    for(Mesh::Vertex_index v : mesh.vertices())
      out[v.idx()] = principal_estimate(Tangent_frame(normals[v.idx()]), sums[v.idx()] * (1 / weights[v.idx()]));
  }

private:
  static Tangent_frame frame_along_first_side(const Face_geometry& face)
  {
    Tangent_frame frame(face.doubled_area_vector / face.doubled_area);
    frame.u = face.sides[0] / std::sqrt(face.squared_lengths[0]);
    frame.v = CGAL::cross_product(frame.normal, frame.u);
    return frame;
  }

  static Tangent_tensor fit(const Face_geometry& face, const Tangent_frame& frame, const std::vector<Vector>& normals)
  {
    double xx = 0, xy = 0, yy = 0;
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for(int i = 0; i < 3; ++i)
    {
      const Vector change =
        normals[face.vertices[previous_corner(i)].idx()] - normals[face.vertices[next_corner(i)].idx()];
      const double x = face.sides[i] * frame.u, y = face.sides[i] * frame.v;
      const double change_u = change * frame.u, change_v = change * frame.v;
      xx += x * x;
      xy += x * y;
      yy += y * y;
      right += Eigen::Vector3d(x * change_u, y * change_u + x * change_v, y * change_v);
    }
    Eigen::Matrix3d normal_matrix;
    normal_matrix << xx, xy, 0, xy, xx + yy, xy, 0, xy, yy;
    const Eigen::Vector3d solution = normal_matrix.ldlt().solve(right);
    return {solution[0], solution[1], solution[2]};
  }

  // `tensor`, given in the face's frame, in the vertex's frame once that has been rotated into the face's plane
  static Tangent_tensor rotated(const Tangent_tensor& tensor, const Tangent_frame& face, const Tangent_frame& vertex)
  {
    const Vector sum = vertex.normal + face.normal;
    const double one_plus_cosine = 1 + vertex.normal * face.normal;
    const auto turn = [&](const Vector& a) { return a - sum * ((a * face.normal) / one_plus_cosine); };
    const Vector u = turn(vertex.u), v = turn(vertex.v);
    const double uu = u * face.u, uv = u * face.v, vu = v * face.u, vv = v * face.v;
    const auto form = [&](double a, double b, double c, double d) {
      return tensor.uu * a * c + tensor.uv * (a * d + b * c) + tensor.vv * b * d;
    };
    return {form(uu, uv, uu, uv), form(uu, uv, vu, vv), form(vu, vv, vu, vv)};
  }
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_RUSINKIEWICZ_2004_H
