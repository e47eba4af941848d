// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes what the README's picture shows: a mesh with its mean curvature and normals at all vertices, and one spider.

#include "../options.h"
#include "../tessellations.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/trace_limbs.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

using namespace CGAL::Spider::benchmark;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace Spider = CGAL::Spider;

namespace {

using Vertex = Mesh::Vertex_index;
using Curvature_estimate = Spider::Curvature_estimate_3<Kernel>;

struct Options
{
  std::string mesh, output;
  double estimation_radius = 2; // a clean scan needs no more, and thin ears allow no more
  double spider_radius = 16;    // far more than estimation takes, so that limbs are seen to follow the surface
  int directions = 12;          // 24 limbs: more would merge around the query point
  std::vector<double> near;

  void add_to(CLI::App& app)
  {
    app.add_option("mesh", mesh, "An OFF, OBJ, PLY or STL file of triangles")->required()->check(CLI::ExistingFile);
    app.add_option("output", output, "The JSON file to write")->required();
    app.add_option("--near", near, "The spider sits at the vertex nearest to this point")->expected(3)->required();
    app.add_option("--estimation-radius", estimation_radius, "In mean edge lengths")->capture_default_str();
    app.add_option("--spider-radius", spider_radius, "In mean edge lengths")->capture_default_str();
    app.add_option("--directions", directions, "Of the spider; two limbs each")->capture_default_str();
  }
};

Mesh read_mesh(const std::string& path)
{
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(path, mesh) || mesh.is_empty() || !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error("cannot read a triangle mesh from " + path);
  return mesh;
}

Vertex nearest_vertex(const Mesh& mesh, const Point& point)
{
  return *std::min_element(mesh.vertices().begin(), mesh.vertices().end(), [&](Vertex v, Vertex w) {
    return CGAL::squared_distance(mesh.point(v), point) < CGAL::squared_distance(mesh.point(w), point);
  });
}

template <typename Coordinates>
nlohmann::json triple(const Coordinates& c)
{
  return {c.x(), c.y(), c.z()};
}

template <typename EstimateMap>
nlohmann::json describe_mesh(const Mesh& mesh, const EstimateMap& estimates)
{
  nlohmann::json points, normals, faces, mean_curvature;
  for(Vertex v : mesh.vertices())
  {
    points.push_back(triple(mesh.point(v)));
    normals.push_back(triple(estimates[v].normal));
    mean_curvature.push_back(estimates[v].mean_curvature()); // JSON has NaN as null
  }
  for(auto face : mesh.faces())
  {
    nlohmann::json corners;
    for(Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
      corners.push_back(v.idx());
    faces.push_back(std::move(corners));
  }
  return {{"points", points}, {"faces", faces}, {"normals", normals}, {"H", mean_curvature}};
}

nlohmann::json describe_spider(const Mesh& mesh, Vertex vertex, const Vector& normal, double radius, int directions)
{
  std::vector<Spider::Limb_3<Mesh>> limbs;
  Spider::trace_limbs(vertex, normal, mesh, std::back_inserter(limbs),
                      Spider::parameters::geodesic_radius(radius).number_of_directions(directions));
  nlohmann::json polylines;
  for(const auto& limb : limbs)
  {
    nlohmann::json polyline;
    for(const Point& p : limb.polyline)
      polyline.push_back(triple(p));
    polylines.push_back(std::move(polyline));
  }
  return {{"query", triple(mesh.point(vertex))}, {"limbs", polylines}};
}

void write_picture(const Options& options)
{
  Mesh mesh = read_mesh(options.mesh);
  const double edge = mean_edge_length(mesh);
  auto estimates = mesh.add_property_map<Vertex, Curvature_estimate>("v:curvature").first;
  Spider::estimate_vertex_curvatures<CGAL::Parallel_if_available_tag>(
    mesh, estimates,
    Spider::parameters::estimator(Spider::surface_fit).geodesic_radius(options.estimation_radius * edge));

  const Vertex vertex = nearest_vertex(mesh, Point(options.near[0], options.near[1], options.near[2]));
  nlohmann::json picture = describe_mesh(mesh, estimates);
  picture["mean_edge_length"] = edge;
  picture["spider"] =
    describe_spider(mesh, vertex, estimates[vertex].normal, options.spider_radius * edge, options.directions);
  std::ofstream out(options.output);
  out << picture;
  if(!out.flush())
    throw std::runtime_error("cannot write " + options.output);
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Writes a mesh with its mean curvature, and the limbs of one spider, for a picture of them.");
  Options options;
  options.add_to(app);
  CLI11_PARSE(app, argc, argv);
  return report_errors([&] { write_picture(options); });
}
