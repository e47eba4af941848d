// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: no mesh crashes anything. Every mesh that comes with CGAL: scans, CAD models, broken and tiny ones.

#include "estimation.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <filesystem>
#include <set>

using namespace estimation;

namespace {

std::vector<std::filesystem::path> mesh_files()
{
  const std::set<std::string> extensions = {".off", ".obj", ".ply", ".stl", ".ts", ".vtp"};
  std::vector<std::filesystem::path> files;
  if(std::filesystem::exists(SPIDER_DATA_DIR))
    for(const auto& entry : std::filesystem::directory_iterator(SPIDER_DATA_DIR))
      if(extensions.count(entry.path().extension().string()))
        files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// reads a file as a triangle mesh: polygons are cut, soups repaired and oriented. There may be none in it.
bool read_triangle_mesh(const std::filesystem::path& file, Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  return PMP::IO::read_polygon_mesh(file.string(), mesh) && PMP::triangulate_faces(mesh) &&
         CGAL::is_triangle_mesh(mesh);
}

} // namespace

TEST(libcgal_demo_meshes, get_sound_answers)
{
  const auto files = mesh_files();
  if(files.empty())
    GTEST_SKIP() << "there are no meshes in " << SPIDER_DATA_DIR << " (Debian and Ubuntu: libcgal-demo)";
  std::size_t number_read = 0, number_valid = 0, number_asked = 0;
  for(const auto& file : files)
  {
    SCOPED_TRACE(file.filename().string());
    Mesh mesh;
    if(!read_triangle_mesh(file, mesh) || mesh.is_empty())
      continue;
    ++number_read;
    for_each_setting(4 * meshes::mean_edge_length(mesh), [&mesh = mesh, &number_asked, &number_valid](const auto& np) {
      const Spider::Curvature_estimator<Mesh, std::decay_t<decltype(np)>> estimator(mesh, np);
      constexpr Mesh::size_type most_queries = 25;
      const Mesh::size_type stride = mesh.number_of_vertices() / most_queries + 1;
      for(Mesh::size_type v = 0; v < mesh.number_of_vertices(); v += stride)
      {
        const Estimate e = estimator(Vertex(v));
        expect_sound(e);
        ++number_asked;
        number_valid += e.is_valid();
      }
    });
  }
  EXPECT_GE(number_read, files.size() * 9 / 10);
  EXPECT_GE(number_valid, number_asked * 95 / 100);
}
