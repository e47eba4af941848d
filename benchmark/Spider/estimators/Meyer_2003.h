// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_MEYER_2003_H
#define CGAL_SPIDER_BENCHMARK_MEYER_2003_H

#include "shared/Constrained_direction_fit.h"

namespace CGAL {
namespace Spider {
namespace benchmark {

// Meyer, Desbrun, Schroeder and Barr, "Discrete differential-geometry operators for triangulated 2-manifolds", 2003.
//   mixed area A              section 3.4 and figure 4: Voronoi in a face without an obtuse angle, else a half of the
//                             face at the obtuse corner and a quarter at the others
//   mean curvature H          equation 8: K(x_i) = sum_j (cot alpha_ij + cot beta_ij)(x_i - x_j) / 2A = 2 H n
//   Gaussian curvature        equation 9: (2 pi - sum of the angles) / A
//   principal curvatures      equations 10 and 11: H +- sqrt(H^2 - K), the root's argument clamped at zero
//   principal directions      section 5.3: the tensor with that trace and that determinant that is nearest, in least
//                             squares weighted by each edge's share of A, to the normal curvatures
//                             2 (x_i - x_j).n / |x_i - x_j|^2 along the edges
// The paper takes n from K(x_i), and averages the faces' normals where the surface is locally flat or a saddle. Where H
// is small against the noise the former is no normal at all, so that the averaged normal serves everywhere here, which
// is to the method's advantage; it also gives H its sign. A border vertex has no angle defect, and so no estimate.
//
// The second variant smooths the fields H and K, as figure 6 of the spider paper does for H: `smoothing_rounds` times
// every vertex moves by `smoothing_factor` towards the mean of its neighbours. The directions stay.
class Meyer_2003 : public Estimator
{
public:
  enum class Smoothing
  {
    none,
    laplacian
  };

  explicit Meyer_2003(Smoothing smoothing) : m_smoothing(smoothing) {}

  std::string name() const override { return m_smoothing == Smoothing::none ? "meyer" : "meyer_smoothed"; }

  std::string settings() const override
  {
    const std::string base = "Meyer et al. 2003, one-ring, averaged normals";
    return m_smoothing == Smoothing::none ? base
                                          : base + "; H and K then smoothed by " + std::to_string(smoothing_rounds) +
                                              " Laplacian rounds of factor 0.2";
  }

  bool uses_radius() const override { return false; }

  void estimate(const Mesh& mesh, double /*radius*/, std::vector<Estimate>& out) const override
  {
    const std::vector<Vector> normals = vertex_normals(mesh, Normal_weight::sphere);
    Fields fields = mean_and_Gaussian_curvatures(mesh, normals);
    const std::vector<Constrained_direction_fit> fits = fit_normal_curvatures(mesh, normals, fields.mean);
    out.assign(mesh.num_vertices(), Estimate());
    for(Mesh::Vertex_index v : mesh.vertices())
      set_directions(fields, fits[v.idx()], normals[v.idx()], v, out[v.idx()]);
    if(m_smoothing == Smoothing::laplacian)
    {
      smooth(mesh, fields.mean);
      smooth(mesh, fields.Gaussian);
    }
    for(Mesh::Vertex_index v : mesh.vertices())
      set_curvatures(fields, v, out[v.idx()]);
  }

private:
  static constexpr int smoothing_rounds = 10; // the spider paper's, figure 6
  static constexpr double smoothing_factor = 0.2;

  struct Fields
  {
    std::vector<double> mean, Gaussian;

    // half the difference of the principal curvatures (equations 10 and 11)
    double deviation(Mesh::Vertex_index v) const
    {
      return std::sqrt((std::max)(0., mean[v.idx()] * mean[v.idx()] - Gaussian[v.idx()]));
    }
  };

  // The parts of the mixed area at a corner that belong to the sides towards the next and the previous corner.
  static std::array<double, 2> mixed_area_shares(const Face_geometry& face, int corner)
  {
    const int obtuse = face.obtuse_corner(), next = next_corner(corner), previous = previous_corner(corner);
    if(obtuse >= 0)
    {
      const double share = face.area() / (corner == obtuse ? 4 : 8);
      return {share, share};
    }
    return {face.cotangent(previous) * face.squared_lengths[previous] / 8,
            face.cotangent(next) * face.squared_lengths[next] / 8};
  }

  static Fields mean_and_Gaussian_curvatures(const Mesh& mesh, const std::vector<Vector>& normals)
  {
    std::vector<Vector> gradients(mesh.num_vertices(), Vector(0, 0, 0)); // of the area: 2 A H n
    std::vector<double> angles(mesh.num_vertices(), 0), areas(mesh.num_vertices(), 0);
    for(Mesh::Face_index f : mesh.faces())
    {
      const Face_geometry face(mesh, f);
      for(int i = 0; i < 3; ++i)
      {
        const int j = next_corner(i), k = previous_corner(i);
        const std::size_t v = face.vertices[i].idx();
        // side k runs from corner i to corner j and is opposite to k, side j from k to i and opposite to j
        gradients[v] += (face.cotangent(j) * face.sides[j] - face.cotangent(k) * face.sides[k]) / 2;
        angles[v] += face.angle(i);
        const std::array<double, 2> shares = mixed_area_shares(face, i);
        areas[v] += shares[0] + shares[1];
      }
    }
    Fields fields{std::vector<double>(mesh.num_vertices(), Estimate::nan),
                  std::vector<double>(mesh.num_vertices(), Estimate::nan)};
    for(Mesh::Vertex_index v : mesh.vertices())
    {
      if(mesh.is_border(v))
        continue;
      const std::size_t i = v.idx();
      const double magnitude = std::sqrt(gradients[i].squared_length()) / (2 * areas[i]);
      fields.mean[i] = std::copysign(magnitude, gradients[i] * normals[i]);
      fields.Gaussian[i] = (2 * CGAL_PI - angles[i]) / areas[i];
    }
    return fields;
  }

  static std::vector<Constrained_direction_fit>
  fit_normal_curvatures(const Mesh& mesh, const std::vector<Vector>& normals, const std::vector<double>& mean)
  {
    std::vector<Constrained_direction_fit> fits(mesh.num_vertices());
    for(Mesh::Face_index f : mesh.faces())
    {
      const Face_geometry face(mesh, f);
      for(int i = 0; i < 3; ++i)
      {
        const std::size_t v = face.vertices[i].idx();
        const Tangent_frame frame(normals[v]);
        const std::array<double, 2> shares = mixed_area_shares(face, i);
        fits[v].add(frame, face.sides[previous_corner(i)], shares[0], mean[v]);
        fits[v].add(frame, -face.sides[next_corner(i)], shares[1], mean[v]);
      }
    }
    return fits;
  }

  static void set_directions(const Fields& fields, const Constrained_direction_fit& fit, const Vector& normal,
                             Mesh::Vertex_index v, Estimate& estimate)
  {
    estimate.normal = normal;
    const double angle = fit.angle(fields.deviation(v));
    if(std::isfinite(angle))
      benchmark::set_directions(estimate, Tangent_frame(normal), angle);
  }

  static void set_curvatures(const Fields& fields, Mesh::Vertex_index v, Estimate& estimate)
  {
    const double mean = fields.mean[v.idx()], deviation = fields.deviation(v);
    if(!std::isfinite(mean) || !std::isfinite(fields.Gaussian[v.idx()]))
      return;
    estimate.min_curvature = mean - deviation;
    estimate.max_curvature = mean + deviation;
  }

  // Vertices without a value neither get one nor give any.
  static void smooth(const Mesh& mesh, std::vector<double>& field)
  {
    std::vector<double> sums(field.size());
    std::vector<int> counts(field.size());
    const auto add = [&](Mesh::Vertex_index v, Mesh::Vertex_index neighbour) {
      if(std::isfinite(field[neighbour.idx()]))
      {
        sums[v.idx()] += field[neighbour.idx()];
        ++counts[v.idx()];
      }
    };
    for(int round = 0; round < smoothing_rounds; ++round)
    {
      std::fill(sums.begin(), sums.end(), 0.);
      std::fill(counts.begin(), counts.end(), 0);
      for(Mesh::Edge_index e : mesh.edges())
      {
        add(mesh.vertex(e, 0), mesh.vertex(e, 1));
        add(mesh.vertex(e, 1), mesh.vertex(e, 0));
      }
      for(std::size_t i = 0; i < field.size(); ++i)
        if(counts[i] > 0)
          field[i] += smoothing_factor * (sums[i] / counts[i] - field[i]);
    }
  }

  Smoothing m_smoothing;
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_MEYER_2003_H
