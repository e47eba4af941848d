// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_FUZZ_CALLS_H
#define CGAL_SPIDER_FUZZ_CALLS_H

#include "fuzz_settings.h"

namespace fuzz {

/// calls every function that estimates or traces at a few points of a mesh, and checks the answers.
void call_at_points(const Mesh& mesh, const Settings& settings, Random& random);

/// calls every function that goes over the whole mesh, and checks the answers.
void call_on_whole_mesh(const Mesh& mesh, const Settings& settings, Random& random);

} // namespace fuzz

#endif // CGAL_SPIDER_FUZZ_CALLS_H
