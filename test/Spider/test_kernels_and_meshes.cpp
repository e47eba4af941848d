// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: any model of FaceGraph and any kernel give the same answers. Written as a user would who has only read
// the reference.

#include "estimation.h"
#include "every_function.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spider.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <type_traits>

namespace {

namespace Spider = CGAL::Spider;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Spider::parameters;

using Plain = CGAL::Simple_cartesian<double>;
using Narrow = CGAL::Simple_cartesian<float>;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Reference_mesh = CGAL::Surface_mesh<Plain::Point_3>;

/// returns an irregular ellipsoid, whose coordinates every kernel represents: they are floats.
template <typename Mesh>
Mesh make_mesh()
{
  const Reference_mesh mesh =
    meshes::moved(meshes::jittered(meshes::icosphere<Reference_mesh>(2), 0.02, 1), [](const meshes::Vector& p) {
      const Eigen::Vector3f rounded = meshes::Vector(2 * p.x(), 1.5 * p.y(), p.z()).cast<float>();
      return meshes::Vector(rounded.cast<double>());
    });
  const estimation::Soup soup = estimation::soup_of(mesh);
  return meshes::from_soup<Mesh>(soup.points, soup.triangles);
}

constexpr double radius = 0.75;

/// what the tests compare, in double
struct Answer
{
  double min, max;
  Spider::Estimate_status status;
  meshes::Vector normal;
};

template <typename Estimate>
Answer answer(const Estimate& e)
{
  return {e.min_curvature, e.max_curvature, e.status, meshes::vector(e.normal)};
}

template <typename Mesh, typename Kernel = typename CGAL::Kernel_traits<meshes::Point_of<Mesh>>::Kernel>
using Estimate_of =
  Spider::Curvature_estimate_3<std::conditional_t<std::is_floating_point<typename Kernel::FT>::value, Kernel, Plain>>;

/// returns the answers at the vertices.

template <typename Mesh, typename NamedParameters>
std::vector<Answer> answers(const Mesh& mesh, const NamedParameters& np)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  std::map<Vertex, Estimate_of<Mesh>> curvature;
  Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, boost::make_assoc_property_map(curvature),
                                                                      np);
  std::vector<Answer> result;
  for(Vertex v : vertices(mesh))
    result.push_back(answer(curvature[v]));
  return result;
}

/// returns the answers at the centres of the faces.
template <typename Mesh, typename NamedParameters>
std::vector<Answer> answers_in_faces(const Mesh& mesh, const NamedParameters& np)
{
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;
  using FT = typename CGAL::Kernel_traits<meshes::Point_of<Mesh>>::Kernel::FT;
  const Spider::Curvature_estimator<Mesh, NamedParameters> estimator(mesh, np);
  const FT third = FT(1) / FT(3);
  std::vector<Answer> result;
  for(Face f : faces(mesh))
    result.push_back(answer(estimator(PMP::Face_location<Mesh, FT>(f, {third, third, third}))));
  return result;
}

void expect_same(const std::vector<Answer>& got, const std::vector<Answer>& expected, double tolerance)
{
  ASSERT_EQ(got.size(), expected.size());
  for(std::size_t i = 0; i < got.size(); ++i)
  {
    EXPECT_EQ(got[i].status, expected[i].status); // `partial` where limbs don't get round the ellipsoid's tip
    EXPECT_TRUE(std::isfinite(got[i].min));
    EXPECT_NEAR(got[i].min, expected[i].min, tolerance * std::abs(expected[i].max)) << i;
    EXPECT_NEAR(got[i].max, expected[i].max, tolerance * std::abs(expected[i].max)) << i;
    EXPECT_LE((got[i].normal - expected[i].normal).norm(), tolerance) << i;
  }
}

template <typename Mesh>
class Kernels_and_meshes : public testing::Test
{};

using Meshes = testing::Types<CGAL::Surface_mesh<Plain::Point_3>, CGAL::Surface_mesh<Narrow::Point_3>,
                              CGAL::Surface_mesh<Inexact::Point_3>, CGAL::Surface_mesh<Exact::Point_3>,
                              CGAL::Polyhedron_3<Plain>, CGAL::Polyhedron_3<Inexact>, CGAL::Polyhedron_3<Exact>>;
TYPED_TEST_SUITE(Kernels_and_meshes, Meshes);

} // namespace

TYPED_TEST(Kernels_and_meshes, answers_are_the_same)
{
  using Kernel = typename CGAL::Kernel_traits<meshes::Point_of<TypeParam>>::Kernel;
  // Computation is in double everywhere, so only the results' own rounding tells kernels apart.
  constexpr double tolerance = std::is_same<Kernel, Narrow>::value ? 1e-6 : 1e-12;
  const auto reference = make_mesh<Reference_mesh>();
  const auto mesh = make_mesh<TypeParam>();
  estimation::for_each_setting(radius, [&](const auto& np) {
    expect_same(answers(mesh, np), answers(reference, np), tolerance);
    expect_same(answers_in_faces(mesh, np), answers_in_faces(reference, np), tolerance);
  });
}

TYPED_TEST(Kernels_and_meshes, every_function_says_the_same)
{
  using Kernel = typename CGAL::Kernel_traits<meshes::Point_of<TypeParam>>::Kernel;
  constexpr double tolerance = std::is_same<Kernel, Narrow>::value ? 1e-4 : 1e-10;
  auto reference = make_mesh<Reference_mesh>();
  auto mesh = make_mesh<TypeParam>();
  const auto expected = every_function::call(reference, radius);
  every_function::expect_same(every_function::call(mesh, radius), expected, tolerance);
}

namespace {

template <typename Mesh>
void expect_points_from_users_map()
{
  Mesh mesh = make_mesh<Mesh>();
  const auto np = params::geodesic_radius(radius);
  const std::vector<Answer> expected = answers(mesh, np);

  using Point = meshes::Point_of<Mesh>;
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, Point> points;
  for(auto v : vertices(mesh))
  {
    points[v] = get(get(CGAL::vertex_point, mesh), v);
    put(get(CGAL::vertex_point, mesh), v, Point(0, 0, 0)); // now the mesh's own points are of no use
  }
  expect_same(answers(mesh, np.vertex_point_map(boost::make_assoc_property_map(points))), expected, 1e-12);
}

} // namespace

TEST(Points_of_the_user, are_taken_in_place_of_the_meshs_own)
{
  expect_points_from_users_map<CGAL::Surface_mesh<Plain::Point_3>>();
  expect_points_from_users_map<CGAL::Polyhedron_3<Exact>>();
}

TEST(Program_of_the_reference, is_right)
{
  using Mesh = Reference_mesh;
  Mesh mesh = meshes::icosphere<Mesh>(4, 0.05);
  auto curvature = mesh.add_property_map<Mesh::Vertex_index, Spider::Curvature_estimate_3<Plain>>("v:curvature").first;
  Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(mesh, curvature,
                                                                      Spider::parameters::geodesic_radius(0.02));
  for(auto v : mesh.vertices())
    EXPECT_NEAR(curvature[v].mean_curvature(), 20, 1);
}
