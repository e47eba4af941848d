// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise (paper, 2.5, generalised): length counts as many times as the face costs that it is in.

#include "estimation.h"

#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/trace_limb.h>

#include <limits>

using namespace estimation;

namespace {

constexpr int n = 20; // patches have (2n)² cells around the origin
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A mesh over the plane whose faces cost more beyond x = 0.5.
struct Dear_half
{
  template <typename Height>
  Dear_half(double cost, Height&& height)
    : mesh(meshes::height_field<Mesh>(n, 0.1, height)),
      costs(mesh.add_property_map<Mesh::Face_index, double>("f:cost", 1).first)
  {
    for(auto f : mesh.faces())
    {
      double x = 0;
      for(Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
        x += meshes::point(mesh, v).x() / 3;
      costs[f] = x > 0.5 ? cost : 1;
    }
  }

  Vertex vertex_at(int i, int j) const { return Vertex(static_cast<Mesh::size_type>((2 * n + 1) * (i + n) + j + n)); }

  Mesh mesh;
  Mesh::Property_map<Mesh::Face_index, double> costs;
};

double flat(double, double) { return 0; }

} // namespace

TEST(growth_cost, length_in_a_dear_face_counts_for_more)
{
  const Dear_half sheet(4, flat);
  const Vertex origin = sheet.vertex_at(0, 0);
  const Kernel::Vector_3 up(0, 0, 1);
  for(Spider::Limb_measure measure : {Spider::arc_length, Spider::tangential_distance})
    for(double angle : {0.05, 0.7, 1.2})
    {
      const Kernel::Vector_3 direction(std::cos(angle), std::sin(angle), 0);
      const double to_border = 0.5 / std::cos(angle), r = to_border + 0.2;
      const auto limb =
        Spider::trace_limb(origin, up, direction, sheet.mesh,
                           params::geodesic_radius(r).limb_measure(measure).growth_cost_map(sheet.costs));
      EXPECT_EQ(limb.end, Spider::slowed);
      EXPECT_NEAR(limb.length, to_border + 0.2 / 4, 1e-12);
      EXPECT_NEAR((meshes::vector(limb.polyline.back()) - limb.length * meshes::vector(direction)).norm(), 0, 1e-12);

      const auto cheap =
        Spider::trace_limb(origin, up, -direction, sheet.mesh, params::geodesic_radius(r).growth_cost_map(sheet.costs));
      EXPECT_EQ(cheap.end, Spider::radius_reached);
      EXPECT_EQ(cheap.length, r);

      // From the dear half into the cheap one: 0.1 cost 0.4 and leave 0.2.
      const Vertex beyond = sheet.vertex_at(6, 0);
      const auto back = Spider::trace_limb(beyond, up, Kernel::Vector_3(-1, 0, 0), sheet.mesh,
                                           params::geodesic_radius(0.6).growth_cost_map(sheet.costs));
      EXPECT_EQ(back.end, Spider::slowed);
      EXPECT_NEAR(back.length, 0.3, 1e-12);
    }
}

TEST(growth_cost, limbs_stop_at_faces_of_infinite_cost)
{
  const Dear_half sheet(infinity, flat);
  const auto np = params::geodesic_radius(1).growth_cost_map(sheet.costs);
  const auto limb =
    Spider::trace_limb(sheet.vertex_at(0, 0), Kernel::Vector_3(0, 0, 1), Kernel::Vector_3(1, 0.3, 0), sheet.mesh, np);
  EXPECT_EQ(limb.end, Spider::slowed);
  EXPECT_NEAR(limb.polyline.back().x(), 0.5, 1e-12);
  EXPECT_EQ(meshes::point(sheet.mesh, sheet.mesh.vertex(limb.edge, 0)).x(), 0.5);
  EXPECT_EQ(meshes::point(sheet.mesh, sheet.mesh.vertex(limb.edge, 1)).x(), 0.5);

  const auto none =
    Spider::trace_limb(sheet.vertex_at(8, 0), Kernel::Vector_3(0, 0, 1), Kernel::Vector_3(1, 0.3, 0), sheet.mesh, np);
  EXPECT_EQ(none.end, Spider::slowed);
  EXPECT_EQ(none.length, 0);
}

TEST(growth_cost, estimates_are_those_of_the_surface_on_this_side)
{
  // A cylinder of curvature 1 / 2 whose axis is y, that turns into a plane where limbs stop.
  const auto height = [](double x, double) {
    const double bent = std::min(x, 0.5);
    return std::sqrt(4 - bent * bent) - (x - bent) * 0.5 / std::sqrt(3.75);
  };
  for(double cost : {infinity, 1e6})
  {
    const Dear_half sheet(cost, height);
    auto mesh = sheet.mesh;
    auto curvature = mesh.add_property_map<Vertex, Estimate>("v:curvature").first;
    const auto np = params::geodesic_radius(0.4).growth_cost_map(sheet.costs);
    Spider::estimate_vertex_curvatures(sheet.mesh, curvature, np);
    for(int i : {-3, 2, 4})
    {
      const Vertex v = sheet.vertex_at(i, 0);
      const Estimate single = Spider::estimate_curvature(v, sheet.mesh, np);
      EXPECT_NEAR(single.max_curvature, 0.5,
                  0.006); // what a quadric makes of a part of an arc, measured 0.0043 at most
      EXPECT_NEAR(single.min_curvature, 0, 0.006);
      EXPECT_EQ(single.status, i < 1 ? Spider::ok : Spider::partial);
      EXPECT_EQ(single.coverage < 1, i >= 1);
      expect_same(single, curvature[v], 1e-9);
    }
    const Estimate beyond = Spider::estimate_curvature(sheet.vertex_at(12, 0), sheet.mesh, np);
    if(!std::isfinite(cost))
    {
      EXPECT_EQ(beyond.status, Spider::insufficient);
    }
  }
}

TEST(growth_cost, a_cost_below_one_is_refused)
{
  for(double cost : {0.5, 0., -1., std::nan("")})
  {
    const Dear_half sheet(cost, flat);
    auto mesh = sheet.mesh;
    auto curvature = mesh.add_property_map<Vertex, Estimate>("v:curvature").first;
    EXPECT_THROW(Spider::estimate_vertex_curvatures(sheet.mesh, curvature, params::growth_cost_map(sheet.costs)),
                 std::invalid_argument);
  }
}
