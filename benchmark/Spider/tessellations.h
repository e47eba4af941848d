// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_TESSELLATIONS_H
#define CGAL_SPIDER_BENCHMARK_TESSELLATIONS_H

#include "Random.h"
#include "Shape.h"

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

// How a shape is cut into triangles:
// - regular: even rows, nearly all vertices of valence six;
// - irregular: the vertices of the regular mesh are moved about at random until their order is lost, and the edges
//   are flipped to Delaunay;
// - slivers: the rows' spacing varies 20-fold, and a tenth of all edges is flipped.
enum class Tessellation
{
  regular,
  irregular,
  slivers
};

std::vector<std::string> tessellation_names();
Tessellation tessellation_of(const std::string& name);

// A mesh of about `number_of_vertices` vertices, all of them on the shape.
Mesh tessellate(const Shape& shape, Tessellation tessellation, std::size_t number_of_vertices, Random& random);

// Flips edges until the angles opposite to each add up to no more than pi. No face is left that is turned away from
// the unit normals, one per vertex.
void flip_to_Delaunay(Mesh& mesh, const std::vector<Vector>& normals);

// Flips about the given share of all edges, chosen at random, where the result is a mesh that isn't folded.
void flip_at_random(Mesh& mesh, const std::vector<Vector>& normals, double share, Random& random);

// The average of the unit normals of each vertex' faces, weighted by area: for meshes without exact normals.
std::vector<Vector> area_weighted_normals(const Mesh& mesh);

double mean_edge_length(const Mesh& mesh);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_TESSELLATIONS_H
