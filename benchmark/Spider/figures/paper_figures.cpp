// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes what the paper's figures show, computed anew, for render_figures.py.

#include "../options.h"
#include "Figure.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>

using namespace CGAL::Spider::benchmark;

namespace {

const std::map<std::string, std::function<Figure(const Figure_input&)>> figures = {
  {"1", figure_1}, {"2", figure_2}, {"3", figure_3}, {"4", figure_4},   {"5", figure_5},  {"6", figure_6},
  {"7", figure_7}, {"8", figure_8}, {"9", figure_9}, {"10", figure_10}, {"11", figure_11}};

void write(const std::string& number, const Figure_input& input, const std::filesystem::path& directory)
{
  const std::filesystem::path path = directory / ("figure_" + number + ".json");
  std::ofstream out(path);
  out << figures.at(number)(input).json();
  if(!out.flush())
    throw std::runtime_error("cannot write " + path.string());
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Writes what the paper's figures show, for render_figures.py.");
  Figure_input input;
  std::string directory;
  std::vector<std::string> numbers;
  app.add_option("data", input.data, "The directory of CGAL's meshes")->required()->check(CLI::ExistingDirectory);
  app.add_option("output", directory, "The directory for figure_<number>.json")->required();
  app.add_option("numbers", numbers, "Of the figures; all if none is given")->check(CLI::IsMember(figures));
  CLI11_PARSE(app, argc, argv);
  if(numbers.empty())
    for(const auto& figure : figures)
      numbers.push_back(figure.first);
  return report_errors([&] {
    std::filesystem::create_directories(directory);
    Progress progress(numbers.size(), false);
    for(const std::string& number : numbers)
    {
      write(number, input, directory);
      progress.step();
    }
  });
}
