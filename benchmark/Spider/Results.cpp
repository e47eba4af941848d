// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Results.h"

#include <CGAL/version.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

// the table that holds whole meshes, which are nothing for CSV
const char* const pictures = "pictures";

// Names hold no quotation marks, so that quotation marks around them suffice; NaN is null in JSON and empty in CSV.
std::string csv_cell(const Row& value) { return value.is_null() ? std::string() : value.dump(); }

void write_csv(std::ostream& out, const Row& rows)
{
  // rows may lack columns that others have
  std::vector<std::string> columns;
  std::set<std::string> known;
  for(const Row& row : rows)
    for(const auto& cell : row.items())
      if(known.insert(cell.key()).second)
        columns.push_back(cell.key());

  const auto write_line = [&](const auto& text) {
    for(std::size_t i = 0; i < columns.size(); ++i)
      out << (i > 0 ? "," : "") << text(columns[i]);
    out << '\n';
  };
  write_line([](const std::string& column) { return column; });
  for(const Row& row : rows)
    write_line([&](const std::string& column) { return row.contains(column) ? csv_cell(row[column]) : ""; });
}

std::ofstream open(const std::filesystem::path& path)
{
  std::ofstream file(path);
  if(!file)
    throw std::runtime_error("cannot write " + path.string());
  return file;
}

// nlohmann's library writes NaN as null only when it dumps; here it is null from the start
Row number(double value) { return std::isfinite(value) ? Row(value) : Row(nullptr); }

void append(Row& row, const std::string& name, const Summary& summary)
{
  row[name + "_mean"] = number(summary.mean);
  row[name + "_median"] = number(summary.median);
  row[name + "_95"] = number(summary.percentile_95);
  row[name + "_worst"] = number(summary.worst);
}

} // namespace

Results::Results(std::string program, std::string command_line) : program(std::move(program))
{
  content["program"] = this->program;
  content["command_line"] = std::move(command_line);
  content["CGAL"] = CGAL_VERSION_STR;
  content["compiler"] = __VERSION__;
  content["estimators"] = Row::array();
  content["tables"] = Row::object();
}

void Results::describe(const Estimators& estimators)
{
  for(const auto& estimator : estimators)
    content["estimators"].push_back(
      {{"name", estimator->name()}, {"settings", estimator->settings()}, {"uses_radius", estimator->uses_radius()}});
}

void Results::add(const std::string& table, Row row) { content["tables"][table].push_back(std::move(row)); }

void Results::write(const std::string& directory) const
{
  const std::filesystem::path path(directory);
  std::filesystem::create_directories(path);
  open(path / (program + ".json")) << content.dump() << '\n';
  for(const auto& table : content["tables"].items())
  {
    if(table.key() == pictures)
      continue;
    std::ofstream file = open(path / (program + "_" + table.key() + ".csv"));
    write_csv(file, table.value());
  }
}

void append(Row& row, const Errors& errors)
{
  append(row, "H", errors.H);
  append(row, "K", errors.K);
  append(row, "min_curvature", errors.min_curvature);
  append(row, "max_curvature", errors.max_curvature);
  append(row, "direction", errors.direction);
  append(row, "normal", errors.normal);
  row["vertices"] = errors.vertices;
  row["nan"] = errors.nan;
  row["wild"] = errors.wild;
}

std::string to_text(double number)
{
  if(std::isnan(number))
    return "-";
  std::ostringstream text;
  if(number == 0 || (number >= 0.001 && number < 1000))
    text << std::fixed
         << std::setprecision(number >= 100   ? 0
                              : number >= 10  ? 1
                              : number >= 1   ? 2
                              : number >= 0.1 ? 3
                                              : 4)
         << number;
  else
    text << std::scientific << std::setprecision(1) << number;
  return text.str();
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
