// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_FIGURE_H
#define CGAL_SPIDER_BENCHMARK_FIGURE_H

#include "../Estimator.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

// Where figures get meshes from, and what they are asked to be.
struct Figure_input
{
  std::string data; // the directory of CGAL's meshes

  Mesh mesh(const std::string& name) const;
};

// What one figure shows, for render_figures.py, and what it claims.
class Figure
{
public:
  Figure(int number, std::string title);

  // A mesh under a name, and a picture of it; what is added after a panel is part of that panel.
  void add_mesh(const std::string& name, const Mesh& mesh);
  void add_panel(const std::string& title, const std::string& mesh);
  void add_field(const std::string& name, const std::vector<double>& values); // one value per vertex
  void add_vectors(const std::vector<Vector>& vectors);                       // one per vertex
  void add_lines(const std::string& kind, const std::vector<std::vector<Point>>& lines);
  void add_points(const std::string& kind, const std::vector<Point>& points);
  void set(const std::string& name, const nlohmann::json& value); // of the panel

  // A curve over the radius in mean edge lengths, for figure 5.
  void add_curve(const std::string& name, const std::vector<double>& x, const std::vector<double>& y);

  // What the paper says, what was measured here, and whether that bears it out.
  void add_claim(const std::string& about, const std::string& paper, const std::string& ours, bool is_reproduced);
  // A number that the paper doesn't give.
  void add_number(const std::string& about, const std::string& ours);

  const nlohmann::json& json() const { return m_json; }

private:
  nlohmann::json& panel() { return m_json["panels"].back(); }

  nlohmann::json m_json;
};

// returns the number with three significant digits.
std::string digits(double value);

// The figures of the paper (figures 1 and 2 in figures_of_spiders.cpp, and so on).
Figure figure_1(const Figure_input&);
Figure figure_2(const Figure_input&);
Figure figure_3(const Figure_input&);
Figure figure_4(const Figure_input&);
Figure figure_5(const Figure_input&);
Figure figure_6(const Figure_input&);
Figure figure_7(const Figure_input&);
Figure figure_8(const Figure_input&);
Figure figure_9(const Figure_input&);
Figure figure_10(const Figure_input&);
Figure figure_11(const Figure_input&);

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_FIGURE_H
