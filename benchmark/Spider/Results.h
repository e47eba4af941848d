// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_RESULTS_H
#define CGAL_SPIDER_BENCHMARK_RESULTS_H

#include "Estimator.h"
#include "measures.h"

#include <nlohmann/json.hpp>

#include <string>

namespace CGAL {
namespace Spider {
namespace benchmark {

// A row of a table: its columns in the order in which they were set.
using Row = nlohmann::ordered_json;

// What a program found out: named tables of rows, written to one JSON file and one CSV file per table.
class Results
{
public:
  // `command_line` is what reproduces them
  Results(std::string program, std::string command_line);

  // puts the names and the settings of the estimators on record
  void describe(const Estimators& estimators);

  void add(const std::string& table, Row row);

  // writes <directory>/<program>.json, and a <program>_<table>.csv for each table but "pictures"; std::runtime_error if
  // it can't
  void write(const std::string& directory) const;

private:
  std::string program;
  nlohmann::ordered_json content;
};

// appends the columns "H_mean", "H_median", ..., "nan", "wild" to a row
void append(Row& row, const Errors& errors);

// what a person reads: three digits
std::string to_text(double number);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_RESULTS_H
