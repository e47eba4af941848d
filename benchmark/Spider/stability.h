// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_STABILITY_H
#define CGAL_SPIDER_BENCHMARK_STABILITY_H

#include "measures.h"

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

// The same surface cut into other triangles, to see how much an estimator's answer changes:
// - "flipped": a tenth of the edges flipped, all vertices kept;
// - "remeshed": PMP::isotropic_remeshing() to the same mean edge length, vertices on the old faces.
std::vector<std::pair<std::string, Mesh>> other_triangulations(const Mesh& mesh);

// What estimates at the vertices of one mesh say at the vertices of another: curvatures interpolated within the face
// that is nearest, directions and normals those of its nearest corner.
std::vector<Estimate> transfer(const Mesh& from, const std::vector<Estimate>& estimates, const Mesh& to);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_STABILITY_H
