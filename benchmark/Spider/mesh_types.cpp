// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_types.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <memory>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

// A property map that keeps nothing but a sum.
template <typename TriangleMesh>
struct Sum_of_curvatures
{
  using key_type = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using value_type = typename Curvature_estimator<TriangleMesh>::Estimate;
  using reference = void;
  using category = boost::writable_property_map_tag;

  double* sum;

  friend void put(const Sum_of_curvatures& map, const key_type&, const value_type& estimate)
  {
    if(estimate.is_valid())
      *map.sum += estimate.mean_curvature();
  }
};

template <typename TriangleMesh, typename NamedParameters>
double run(const TriangleMesh& mesh, int threads, const NamedParameters& np)
{
  double sum = 0;
  const Sum_of_curvatures<TriangleMesh> map{&sum};
  if(threads == 1)
  {
    estimate_vertex_curvatures(mesh, map, np);
    return sum;
  }
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  estimate_vertex_curvatures<CGAL::Parallel_tag>(mesh, map, np);
  return sum;
#else
  throw std::runtime_error("more than one thread takes TBB, which this program was built without");
#endif
}

template <typename TriangleMesh>
Mesh_type mesh_type(std::string name)
{
  return {std::move(name), [](const Mesh& mesh) -> Spider_run {
            const auto copy = std::make_shared<TriangleMesh>();
            CGAL::copy_face_graph(mesh, *copy);
            return [copy](const Spider_settings& settings) {
              const auto np = parameters::geodesic_radius(settings.radius);
              return settings.directions == 0
                       ? run(*copy, settings.threads, np)
                       : run(*copy, settings.threads, np.number_of_directions(settings.directions));
            };
          }};
}

} // namespace

std::vector<Mesh_type> all_mesh_types()
{
  using Float_kernel = CGAL::Simple_cartesian<float>;
  return {mesh_type<Mesh>("Surface_mesh<double>"),
          mesh_type<CGAL::Surface_mesh<Float_kernel::Point_3>>("Surface_mesh<float>"),
          mesh_type<CGAL::Polyhedron_3<Kernel>>("Polyhedron_3<double>"),
          mesh_type<CGAL::Polyhedron_3<Float_kernel>>("Polyhedron_3<float>")};
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
