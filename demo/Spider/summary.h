// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_DEMO_SUMMARY_H
#define CGAL_SPIDER_DEMO_SUMMARY_H

#include "Jet_estimator.h"
#include "write_mesh.h"

#include <ostream>
#include <vector>

namespace CGAL {
namespace Spider {
namespace demo {

// What one method answered, and how long it took.
template <typename Answer>
struct Run
{
  std::vector<Answer> answers; // one per vertex
  double seconds;
};

// prints time, vertices by status and the distributions of H and K, the two methods side by side, and how far they
// agree.
void print_summary(std::ostream& out, const Run<Estimate>& spider, const Run<Jet_estimate>& jets);

} // namespace demo
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_DEMO_SUMMARY_H
