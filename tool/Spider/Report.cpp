// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Report.h"

#include "Summary.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

constexpr int label_width = 24;
constexpr int column_width = 16;
constexpr int digits = 4; // of numbers that are statistics of estimates

std::vector<Summary> summaries_of(const Report& report)
{
  const auto status = [](const Estimate& estimate) { return estimate.status; };
  const auto jets_status = [](const Jet_estimate& estimate) {
    return std::isnan(estimate.mean_curvature()) ? insufficient : ok;
  };
  std::vector<Summary> summaries;
  for(std::size_t i = 0; i < report.runs.size(); ++i)
    summaries.push_back(
      summarise(report.runs.size() == 1 ? "Spider" : "r = " + report.radii[i].name, report.runs[i], status));
  if(report.jets)
    summaries.push_back(summarise("jets, d = 2", *report.jets, jets_status));
  return summaries;
}

template <typename Value>
void print_row(std::ostream& out, const std::string& label, const std::vector<Summary>& summaries, const Value& value)
{
  out << std::left << std::setw(label_width) << label << std::right << std::setprecision(digits);
  for(const Summary& summary : summaries)
    out << std::setw(column_width) << value(summary);
  out << '\n';
}

void print_distribution(std::ostream& out, const std::string& name, const std::vector<Summary>& summaries,
                        std::array<double, shown_quantiles.size()> Summary::*values)
{
  constexpr int name_width = 12;
  for(std::size_t i = 0; i < shown_quantiles.size(); ++i)
  {
    std::string label = i == 0 ? name : "";
    label.resize(name_width, ' ');
    print_row(out, label + std::to_string(std::lround(100 * shown_quantiles[i])) + " %", summaries,
              [&](const Summary& summary) { return (summary.*values)[i]; });
  }
}

void print_summaries(std::ostream& out, const std::vector<Summary>& summaries)
{
  print_row(out, "", summaries, [](const Summary& summary) { return summary.title; });
  print_row(out, "time, s", summaries, [](const Summary& summary) { return summary.seconds; });
  print_row(out, "  per vertex, us", summaries, [](const Summary& s) { return s.microseconds_per_vertex(); });
  for(Estimate_status status : {ok, partial, insufficient, isolated})
  {
    std::ostringstream label;
    label << (status == ok ? "vertices " : "  ") << status;
    print_row(out, label.str(), summaries, [&](const Summary& summary) { return summary.by_status[status]; });
  }
  print_distribution(out, "H", summaries, &Summary::H);
  print_distribution(out, "K", summaries, &Summary::K);
}

// of the jets, so that the unit in which Spider's difference from them is told isn't Spider's own
double root_mean_square_curvature(const std::vector<Jet_estimate>& jets)
{
  double sum = 0;
  std::size_t count = 0;
  for(const Jet_estimate& e : jets)
    if(!std::isnan(e.mean_curvature()))
    {
      sum += (e.min_curvature * e.min_curvature + e.max_curvature * e.max_curvature) / 2;
      ++count;
    }
  return std::sqrt(sum / count);
}

struct Comparison
{
  Agreement in_H;
  double unit; // root mean square curvature
  double ratio_of_times;
};

Comparison compare(const Run<Estimate>& spider, const Run<Jet_estimate>& jets)
{
  return {agreement(values(spider.answers, mean_curvature), values(jets.answers, mean_curvature)),
          root_mean_square_curvature(jets.answers), spider.seconds / jets.seconds};
}

void print_comparison(std::ostream& out, const Comparison& comparison)
{
  const auto& [in_H, unit, ratio] = comparison;
  out << "\nSpider takes " << ratio << " times as long as jets.\n";
  if(std::isnan(in_H.median_difference))
    out << "No vertex has an answer of both, so there is nothing to compare.\n";
  else
    out << "H of the two differs by " << in_H.median_difference / unit << " (median) and "
        << in_H.large_difference / unit << " (95th percentile)\nof the root mean square curvature, " << unit
        << "; their correlation is " << in_H.correlation << ".\n";
}

std::vector<std::size_t> count_labels(const Labels& labels)
{
  std::vector<std::size_t> counts(unlabelled + 1, 0);
  for(Vertex_label label : labels.of_vertex)
    ++counts[label];
  return counts;
}

struct Ridge_totals
{
  std::size_t lines = 0;
  double length = 0, strength = 0; // of all lines together
};

Ridge_totals totals(const std::vector<Ridge>& ridges, Ridge_kind kind)
{
  Ridge_totals sum;
  for(const Ridge& line : ridges)
    if(line.kind == kind)
    {
      ++sum.lines;
      sum.length += length(line.points);
      sum.strength += line.strength;
    }
  return sum;
}

void print_uses(std::ostream& out, const Report& report)
{
  for(const Labels& labels : report.labels)
  {
    out << "\nlabels, flat up to " << labels.threshold << ':';
    const auto counts = count_labels(labels);
    for(int label = 0; label <= unlabelled; ++label)
      out << (label == 0 ? " " : ", ") << counts[label] << ' ' << static_cast<Vertex_label>(label);
    out << '\n';
  }
  for(const Isolines& isolines : report.isolines)
    out << "\n"
        << isolines.request.field << " = " << isolines.request.value << " along " << isolines.lines.size()
        << " lines of length " << isolines.length() << " in all\n";
  if(report.ridges)
  {
    const Ridge_totals ridges = totals(*report.ridges, ridge), valleys = totals(*report.ridges, valley);
    out << '\n'
        << ridges.lines << " ridges of length " << ridges.length << " in all, " << valleys.lines
        << " valleys of length " << valleys.length << '\n';
  }
}

void print_mesh(std::ostream& out, const Report& report)
{
  out << report.mesh_file << ": " << report.vertices << " vertices, " << report.faces << " triangles, mean edge length "
      << report.mean_edge_length << '\n';
  if(report.feature_edges > 0)
    out << report.feature_edges << " feature edges\n";
  if(report.smoothing)
    out << report.smoothing->number_of_iterations << " rounds of smoothing moved vertices by "
        << report.smoothing->mean_displacement << ", at most by " << report.smoothing->greatest_displacement << '\n';
  for(const Radius& radius : report.radii)
  {
    const auto [least, greatest] = std::minmax_element(radius.of_vertex.begin(), radius.of_vertex.end());
    out << "radius " << *least;
    if(*least == *greatest)
      out << ", " << *least / report.mean_edge_length << " mean edge lengths\n";
    else
      out << " to " << *greatest << ", by vertex\n";
  }
}

nlohmann::json distribution(const std::array<double, shown_quantiles.size()>& values)
{
  return {{"p5", values[0]}, {"p25", values[1]}, {"median", values[2]}, {"p75", values[3]}, {"p95", values[4]}};
}

nlohmann::json to_json(const Summary& summary)
{
  nlohmann::json result = {{"title", summary.title},
                           {"seconds", summary.seconds},
                           {"microseconds_per_vertex", summary.microseconds_per_vertex()},
                           {"H", distribution(summary.H)},
                           {"K", distribution(summary.K)}};
  for(Estimate_status status : {ok, partial, insufficient, isolated})
  {
    std::ostringstream name;
    name << status;
    result["vertices"][name.str()] = summary.by_status[status];
  }
  return result;
}

nlohmann::json to_json(const Labels& labels)
{
  nlohmann::json result = {{"threshold", labels.threshold}};
  const auto counts = count_labels(labels);
  for(int label = 0; label <= unlabelled; ++label)
  {
    std::ostringstream name;
    name << static_cast<Vertex_label>(label);
    result[name.str()] = counts[label];
  }
  return result;
}

nlohmann::json to_json(const Ridge_totals& totals)
{
  return {{"lines", totals.lines}, {"length", totals.length}, {"strength", totals.strength}};
}

nlohmann::json to_json(const Comparison& comparison)
{
  return {{"ratio_of_times", comparison.ratio_of_times},
          {"median_difference_of_H", comparison.in_H.median_difference},
          {"p95_difference_of_H", comparison.in_H.large_difference},
          {"correlation_of_H", comparison.in_H.correlation},
          {"root_mean_square_curvature", comparison.unit}};
}

nlohmann::json run_to_json(const Report& report, std::size_t run, const Summary& summary)
{
  const auto& lengths = report.radii[run].of_vertex;
  const auto [least, greatest] = std::minmax_element(lengths.begin(), lengths.end());
  nlohmann::json result = to_json(summary);
  result["radius"] = {{"name", report.radii[run].name}, {"least", *least}, {"greatest", *greatest}};
  if(!report.labels.empty())
    result["labels"] = to_json(report.labels[run]);
  return result;
}

} // namespace

void print(std::ostream& out, const Report& report)
{
  print_mesh(out, report);
  out << '\n';
  print_summaries(out, summaries_of(report));
  if(report.jets)
    print_comparison(out, compare(report.runs.front(), *report.jets));
  print_uses(out, report);
  out << '\n';
  for(const std::string& file : report.written_files)
    out << "written: " << file << '\n';
  if(report.written_files.empty())
    out << "Nothing is written: --output FILE.ply would be, with all estimates and H as its colour.\n";
}

nlohmann::json to_json(const Report& report)
{
  nlohmann::json result = {{"mesh",
                            {{"file", report.mesh_file},
                             {"vertices", report.vertices},
                             {"faces", report.faces},
                             {"mean_edge_length", report.mean_edge_length},
                             {"feature_edges", report.feature_edges}}},
                           {"written_files", report.written_files},
                           {"runs", nlohmann::json::array()},
                           {"isolines", nlohmann::json::array()}};
  if(report.smoothing)
    result["smoothing"] = {{"rounds", report.smoothing->number_of_iterations},
                           {"mean_displacement", report.smoothing->mean_displacement},
                           {"greatest_displacement", report.smoothing->greatest_displacement},
                           {"volume_before", report.smoothing->volume_before},
                           {"volume_after", report.smoothing->volume_after}};
  const std::vector<Summary> summaries = summaries_of(report);
  for(std::size_t i = 0; i < report.runs.size(); ++i)
    result["runs"].push_back(run_to_json(report, i, summaries[i]));
  if(report.jets)
  {
    result["jets"] = to_json(summaries.back());
    result["jets"]["comparison"] = to_json(compare(report.runs.front(), *report.jets));
  }
  for(const Isolines& isolines : report.isolines)
    result["isolines"].push_back({{"field", isolines.request.field},
                                  {"value", isolines.request.value},
                                  {"lines", isolines.lines.size()},
                                  {"length", isolines.length()}});
  if(report.ridges)
  {
    result["ridges"] = to_json(totals(*report.ridges, ridge));
    result["valleys"] = to_json(totals(*report.ridges, valley));
  }
  return result;
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
