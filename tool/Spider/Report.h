// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_REPORT_H
#define CGAL_SPIDER_TOOL_REPORT_H

#include "Isolines.h"
#include "Jet_estimator.h"
#include "Ridges.h"
#include "Vertex_table.h"
#include "smooth.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// What the program found out and did.
struct Report
{
  std::string mesh_file;
  std::size_t vertices, faces;
  double mean_edge_length;
  std::size_t feature_edges;
  std::optional<Smoothing_result<double>> smoothing;
  std::vector<Radius> radii;
  std::vector<Run<Estimate>> runs;          // one for each radius
  std::optional<Run<Jet_estimate>> jets;    // of the first radius
  std::vector<Labels> labels;               // one for each radius, or none
  std::vector<Isolines> isolines;           // of the first radius
  std::optional<std::vector<Ridge>> ridges; // of the first radius
  std::vector<std::string> written_files;
};

// for people: a column for each method and radius
void print(std::ostream& out, const Report& report);

// for programs; what is no number is null
nlohmann::json to_json(const Report& report);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_REPORT_H
