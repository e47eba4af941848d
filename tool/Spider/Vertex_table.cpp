// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Vertex_table.h"

#include "colour.h"
#include "fields.h"
#include "statistics.h"

#include <cmath>
#include <sstream>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

template <typename Member>
Column vector_column(const std::string& name, const Run<Estimate>& run, Member member)
{
  return {name, Column::vector, [&run, member](Vertex v, int i) { return (run.answers[v].*member)[i]; }};
}

void add_columns(std::vector<Column>& columns, const Run<Estimate>& run, const Radius& radius,
                 const std::string& suffix)
{
  columns.push_back(vector_column("normal" + suffix, run, &Estimate::normal));
  for(const Field& field : fields)
    columns.push_back(
      {field.name + suffix, Column::real, [&run, &field](Vertex v, int) { return field.of(run.answers[v]); }});
  columns.push_back(vector_column("min_direction" + suffix, run, &Estimate::min_direction));
  columns.push_back(vector_column("max_direction" + suffix, run, &Estimate::max_direction));
  columns.push_back({"radius" + suffix, Column::real, [&radius](Vertex v, int) { return radius.of_vertex[v]; }});
  columns.push_back(
    {"status" + suffix, Column::code, [&run](Vertex v, int) -> double { return run.answers[v].status; }});
}

// Sharp ridges, few as they are, must not leave the rest of the surface white.
double colour_limit(const Run<Estimate>& run, const Field& field)
{
  std::vector<double> magnitudes;
  for(const Estimate& estimate : run.answers)
    magnitudes.push_back(std::abs(field.of(estimate)));
  return quantile(sorted_numbers(std::move(magnitudes)), 0.9);
}

void colour_by_field(Vertex_table& table, const Run<Estimate>& run, const Field& field)
{
  const double limit = colour_limit(run, field);
  table.colour = [&run, &field, limit](Vertex v) { return diverging_colour(field.of(run.answers[v]), limit); };
  std::ostringstream comment;
  comment << "vertex colour: " << field.name;
  if(field.is_diverging)
    comment << " from " << -limit << " (blue) through 0 (white) to " << limit << " (red)";
  else
    comment << " from 0 (white) to " << limit << " (red)";
  table.comments.push_back(comment.str());
}

template <typename Code>
std::string meaning_of_codes(const std::string& name, int number_of_codes)
{
  std::ostringstream comment;
  comment << "vertex " << name << ':';
  for(int code = 0; code < number_of_codes; ++code)
    comment << (code == 0 ? " " : ", ") << code << ' ' << static_cast<Code>(code);
  return comment.str();
}

} // namespace

Vertex_table make_table(const std::vector<Run<Estimate>>& runs, const std::vector<Radius>& radii,
                        const std::vector<Labels>& labels, const std::string& colour_by)
{
  Vertex_table table;
  for(std::size_t i = 0; i < runs.size(); ++i)
  {
    const std::string suffix = runs.size() == 1 ? "" : "_r" + radii[i].name;
    add_columns(table.columns, runs[i], radii[i], suffix);
    if(!labels.empty())
      table.columns.push_back({"label" + suffix, Column::code,
                               [&of_vertex = labels[i].of_vertex](Vertex v, int) -> double { return of_vertex[v]; }});
  }

  if(colour_by == "label")
    table.colour = [&of_vertex = labels.front().of_vertex](Vertex v) { return label_color(of_vertex[v]); };
  else
    colour_by_field(table, runs.front(), field_of(colour_by));
  table.comments.push_back(meaning_of_codes<Estimate_status>("status", isolated + 1));
  if(!labels.empty())
    table.comments.push_back(meaning_of_codes<Vertex_label>("label", unlabelled + 1));
  return table;
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
