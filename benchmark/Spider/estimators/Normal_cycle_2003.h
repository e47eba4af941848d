// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_NORMAL_CYCLE_2003_H
#define CGAL_SPIDER_BENCHMARK_NORMAL_CYCLE_2003_H

#include "shared/ball_clipping.h"
#include "shared/tangent_tensor.h"

#include <cstdint>

namespace CGAL {
namespace Spider {
namespace benchmark {

// Cohen-Steiner and Morvan, "Restricted Delaunay triangulations and normal cycle", 2003.
//   the measure               over a region B, the sum over edges of beta(e) length(e in B) e e', beta(e) being the
//   angle
//                             between the normals of e's faces, positive where the edge is convex, and e the edge's
//                             unit direction: the simpler of the paper's two anisotropic measures
//   the average               B is the ball of radius r around the vertex; divided by the area in it
//   principal directions      an edge bends the surface across itself, so that the greater curvature is at a right
//   angle
//                             to the eigenvector of the greater eigenvalue
// Of the surface in the ball only the part that is connected to the vertex counts, so that a second sheet does no harm.
// The paper's normal is the eigenvector of the least eigenvalue, which in a flat ball is none; here the normal is that
// of the area in the ball (the sum of its area vectors). H is the paper's own scalar measure, which is the tensor's
// trace; the difference of the curvatures and the directions are those of the tensor restricted to the plane across
// that normal. A border edge has one face, so no angle. Lengths and areas within the ball are exact.
class Normal_cycle_2003 : public Estimator
{
public:
  std::string name() const override { return "normal_cycle"; }

  std::string settings() const override
  {
    return "Cohen-Steiner and Morvan 2003, averaged over the ball of radius r, normal of the area in the ball";
  }

  void estimate(const Mesh& mesh, double radius, std::vector<Estimate>& out) const override
  {
    out.assign(mesh.num_vertices(), Estimate());
    const Measures measures(mesh);
    Ball_sum ball(mesh, measures, radius * radius);
    for(Mesh::Vertex_index v : mesh.vertices())
      if(mesh.halfedge(v) != Mesh::null_halfedge())
        out[v.idx()] = ball(v);
  }

private:
  // what is the same for all balls
  struct Measures
  {
    std::vector<Vector> unit_normals; // by face
    std::vector<double> areas;        // by face
    std::vector<double> bends;        // by edge: beta(e) / |e|, so that times e e' it is the whole edge's measure

    explicit Measures(const Mesh& mesh)
      : unit_normals(mesh.num_faces()), areas(mesh.num_faces()), bends(mesh.num_edges(), 0)
    {
      for(Mesh::Face_index f : mesh.faces())
      {
        const Face_geometry face(mesh, f);
        areas[f.idx()] = face.area();
        unit_normals[f.idx()] = normalized(face.doubled_area_vector);
      }
      for(Mesh::Edge_index e : mesh.edges())
        if(!mesh.is_border(e))
          bends[e.idx()] = bend(mesh, mesh.halfedge(e));
    }

  private:
    double bend(const Mesh& mesh, Mesh::Halfedge_index h) const
    {
      const Vector side = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
      const Vector& normal = unit_normals[mesh.face(h).idx()];
      const Vector& other = unit_normals[mesh.face(mesh.opposite(h)).idx()];
      const double length = std::sqrt(side.squared_length());
      // the sine is along the side where the other face falls away
      const double angle = std::atan2((CGAL::cross_product(normal, other) * side) / length, normal * other);
      return std::isfinite(angle) ? angle / length : 0; // a face without area bends nothing
    }
  };

  // Walks from face to face over the edges that meet the ball; which faces and edges it has met, stamps tell.
  class Ball_sum
  {
  public:
    Ball_sum(const Mesh& mesh, const Measures& measures, double squared_radius)
      : m_mesh(mesh), m_measures(measures), m_squared_radius(squared_radius), m_face_stamps(mesh.num_faces(), 0),
        m_edge_stamps(mesh.num_edges(), 0)
    {}

    Estimate operator()(Mesh::Vertex_index centre)
    {
      ++m_stamp;
      m_faces.clear();
      m_xx = m_xy = m_xz = m_yy = m_yz = m_zz = m_area = 0;
      m_area_vector = Vector(0, 0, 0);
      for(Mesh::Face_index f : m_mesh.faces_around_target(m_mesh.halfedge(centre)))
        meet(f);
      for(std::size_t i = 0; i < m_faces.size(); ++i)
        add_face(m_mesh.point(centre), m_faces[i]);
      return restricted_to_tangent_plane();
    }

  private:
    void meet(Mesh::Face_index f)
    {
      if(f == Mesh::null_face() || m_face_stamps[f.idx()] == m_stamp)
        return;
      m_face_stamps[f.idx()] = m_stamp;
      m_faces.push_back(f);
    }

    void add_face(const Point& centre, Mesh::Face_index f)
    {
      std::array<Vector, 3> corners;
      Mesh::Halfedge_index h = m_mesh.halfedge(f);
      for(int i = 0; i < 3; ++i, h = m_mesh.next(h))
        corners[i] = m_mesh.point(m_mesh.source(h)) - centre;
      for(int i = 0; i < 3; ++i, h = m_mesh.next(h))
        add_edge(corners[i], corners[next_corner(i)] - corners[i], h);
      if(!(m_measures.areas[f.idx()] > 0))
        return;
      const Vector& normal = m_measures.unit_normals[f.idx()];
      const double area = area_in_ball(corners, normal, m_measures.areas[f.idx()], m_squared_radius);
      m_area += area;
      m_area_vector += area * normal;
    }

    void add_edge(const Vector& from_centre, const Vector& side, Mesh::Halfedge_index h)
    {
      const Mesh::Edge_index e = m_mesh.edge(h);
      if(m_edge_stamps[e.idx()] == m_stamp)
        return;
      m_edge_stamps[e.idx()] = m_stamp;
      const Clipped_segment inside(from_centre, side, m_squared_radius);
      if(inside.is_empty())
        return;
      meet(m_mesh.face(m_mesh.opposite(h)));
      const double weight = m_measures.bends[e.idx()] * inside.share();
      m_xx += weight * side.x() * side.x();
      m_xy += weight * side.x() * side.y();
      m_xz += weight * side.x() * side.z();
      m_yy += weight * side.y() * side.y();
      m_yz += weight * side.y() * side.z();
      m_zz += weight * side.z() * side.z();
    }

    Estimate restricted_to_tangent_plane() const
    {
      const Tangent_frame frame(normalized(m_area_vector));
      const auto form = [this](const Vector& a, const Vector& b) {
        return m_xx * a.x() * b.x() + m_yy * a.y() * b.y() + m_zz * a.z() * b.z() +
               m_xy * (a.x() * b.y() + a.y() * b.x()) + m_xz * (a.x() * b.z() + a.z() * b.x()) +
               m_yz * (a.y() * b.z() + a.z() * b.y());
      };
      // turned by a right angle: what the edges along v add is curvature along u. What leans out of the plane belongs
      // to the mean curvature all the same, whose measure is the sum of beta(e) length(e in B), the whole tensor's
      // trace.
      const double out_of_plane = form(frame.normal, frame.normal) / 2;
      const Tangent_tensor turned{form(frame.v, frame.v) + out_of_plane, -form(frame.u, frame.v),
                                  form(frame.u, frame.u) + out_of_plane};
      return principal_estimate(frame, turned * (1 / m_area));
    }

    const Mesh& m_mesh;
    const Measures& m_measures;
    double m_squared_radius;
    std::vector<std::uint32_t> m_face_stamps, m_edge_stamps;
    std::uint32_t m_stamp = 0;
    std::vector<Mesh::Face_index> m_faces;
    double m_xx = 0, m_xy = 0, m_xz = 0, m_yy = 0, m_yz = 0, m_zz = 0, m_area = 0;
    Vector m_area_vector{0, 0, 0};
  };
};

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_NORMAL_CYCLE_2003_H
