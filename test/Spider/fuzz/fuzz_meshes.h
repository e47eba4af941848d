// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Small triangle meshes of every shape and with every defect that input may have.

#ifndef CGAL_SPIDER_FUZZ_MESHES_H
#define CGAL_SPIDER_FUZZ_MESHES_H

#include "Random.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace fuzz {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// returns a mesh, with any number of defects; it may be empty.
Mesh random_mesh(Random& random);

} // namespace fuzz

#endif // CGAL_SPIDER_FUZZ_MESHES_H
