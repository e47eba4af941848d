// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: any model of `FaceGraph` will do, whatever holds it and whatever else is in it.

#include "estimation.h"
#include "every_function.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Spider.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#ifdef SPIDER_HAS_OPENMESH
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/properties_PolyMesh_ArrayKernelT.h>
#endif

#include <boost/property_map/property_map.hpp>

#include <array>
#include <iterator>
#include <map>

using namespace estimation;

namespace {

constexpr double radius = 0.6;
constexpr double rounding = 1e-11; // of curvatures; mesh types visit edges in their own orders

using Location = std::array<double, 3>;

template <typename Point>
Location location(const Point& p)
{
  const Vector a = meshes::vector(p);
  return {a.x(), a.y(), a.z()};
}

/// returns the estimates at all vertices of a mesh, by the vertices' places.
template <typename AnyMesh>
std::map<Location, Estimate> estimates_by_place(const AnyMesh& mesh)
{
  using Any_vertex = typename boost::graph_traits<AnyMesh>::vertex_descriptor;
  const auto point_map = get(CGAL::vertex_point, mesh);
  std::map<Any_vertex, Estimate> curvature;
  Spider::estimate_vertex_curvatures(mesh, boost::make_assoc_property_map(curvature), params::geodesic_radius(radius));
  std::map<Location, Estimate> result;
  for(Any_vertex v : vertices(mesh))
  {
    result[location(get(point_map, v))] = curvature.at(v);
    const auto single = Spider::estimate_curvature(v, mesh, params::geodesic_radius(radius));
    EXPECT_NEAR(single.mean_curvature(), curvature.at(v).mean_curvature(), rounding);
  }
  return result;
}

void expect_same_places(const std::map<Location, Estimate>& got, const std::map<Location, Estimate>& expected)
{
  ASSERT_EQ(got.size(), expected.size());
  for(const auto& [place, estimate] : expected)
  {
    ASSERT_EQ(got.count(place), 1u);
    const Estimate& other = got.at(place);
    EXPECT_EQ(other.status, estimate.status);
    EXPECT_NEAR(other.min_curvature, estimate.min_curvature, rounding);
    EXPECT_NEAR(other.max_curvature, estimate.max_curvature, rounding);
    EXPECT_LE((meshes::vector(other.normal) - meshes::vector(estimate.normal)).norm(), rounding);
  }
}

/// returns a mesh whose coordinates are floats: CGAL passes those of an OpenMesh on as such.
Mesh irregular_sphere()
{
  return meshes::moved(meshes::jittered(meshes::icosphere<Mesh>(2), 0.03, 6),
                       [](const Vector& p) { return Vector(p.cast<float>().cast<double>()); });
}

template <typename Other>
Other copy_of(const Mesh& mesh)
{
  Other other;
  CGAL::copy_face_graph(mesh, other);
  return other;
}

template <typename Other>
void expect_same_of_every_function(double tolerance)
{
  Mesh mesh = irregular_sphere();
  Other other = copy_of<Other>(mesh);
  const auto expected = every_function::call(mesh, radius);
  every_function::expect_same(every_function::call(other, radius), expected, tolerance);
}

} // namespace

TEST(mesh_types, a_linear_cell_complex)
{
  using Complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2, 3, CGAL::Linear_cell_complex_traits<3, CGAL::Exact_predicates_inexact_constructions_kernel>>::type;
  const Mesh mesh = irregular_sphere();
  expect_same_places(estimates_by_place(copy_of<Complex>(mesh)), estimates_by_place(mesh));
  expect_same_of_every_function<Complex>(1e-10);
}

#ifdef SPIDER_HAS_OPENMESH
TEST(mesh_types, an_openmesh)
{
  struct Traits : OpenMesh::DefaultTraits
  {
    using Point = OpenMesh::Vec3d;
  };
  using Polymesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;
  const Mesh mesh = irregular_sphere();
  expect_same_places(estimates_by_place(copy_of<Polymesh>(mesh)), estimates_by_place(mesh));
  expect_same_of_every_function<Polymesh>(1e-7); // CGAL rounds the points that it hands to an OpenMesh to floats
}
#endif

TEST(mesh_types, a_part_of_a_mesh)
{
  Mesh mesh = irregular_sphere(), half = mesh;
  std::vector<Mesh::Face_index> kept;
  for(auto f : mesh.faces())
  {
    if(mesh.point(mesh.target(mesh.halfedge(f))).z() > 0)
      kept.push_back(f);
    else
      CGAL::Euler::remove_face(half.halfedge(f), half);
  }
  const CGAL::Face_filtered_graph<Mesh> part(mesh, kept);
  half.collect_garbage();
  std::map<Location, Estimate> expected = estimates_by_place(half);
  for(auto at = expected.begin(); at != expected.end();) // what isn't of any kept face isn't of the part
    at = at->second.status == Spider::isolated ? expected.erase(at) : std::next(at);
  expect_same_places(estimates_by_place(part), expected);
}

TEST(mesh_types, a_mesh_with_garbage)
{
  Mesh mesh = irregular_sphere();
  for(auto f : mesh.faces())
    if(mesh.point(mesh.target(mesh.halfedge(f))).x() > 0.7)
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  Mesh collected = mesh;
  collected.collect_garbage();
  ASSERT_LT(collected.num_faces(), mesh.num_faces());
  expect_same_places(estimates_by_place(mesh), estimates_by_place(collected));
}

TEST(mesh_types, components_dont_see_each_other)
{
  const Mesh mesh = irregular_sphere();
  const Mesh inner = meshes::moved(mesh, [](const Vector& p) { return Vector(0.9 * p); });
  Mesh both = mesh;
  CGAL::copy_face_graph(inner, both);
  std::map<Location, Estimate> expected = estimates_by_place(mesh);
  expected.merge(estimates_by_place(inner));
  expect_same_places(estimates_by_place(both), expected);
}
