// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_OPTIONS_H
#define CGAL_SPIDER_BENCHMARK_OPTIONS_H

#include <CLI/CLI.hpp>

#include <boost/timer/progress_display.hpp>

#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace benchmark {

// An option that takes a list by commas, one word: what follows it is not its own.
template <typename Value>
CLI::Option* add_list(CLI::App& app, const std::string& name, std::vector<Value>& values,
                      const std::string& description)
{
  return app.add_option(name, values, description)->delimiter(',')->allow_extra_args(false)->capture_default_str();
}

// The options that all programs share.
struct Common_options
{
  std::string output;
  bool quick = false;
  bool no_progress = false;

  void add_to(CLI::App& app)
  {
    app.add_option("--output", output, "Directory for the results as CSV and JSON");
    app.add_flag("--quick", quick, "Few settings: ends within a minute. Options given beside it win");
    app.add_flag("--no-progress", no_progress, "Show no progress bar");
  }
};

// The options of programs that compare estimators.
struct Estimator_options : Common_options
{
  std::vector<std::string> estimators;

  void add_to(CLI::App& app)
  {
    add_list(app, "--estimators", estimators, "Names or parts of names, by commas; all if none is given");
    Common_options::add_to(app);
  }
};

// What was typed, without the path of the program.
inline std::string command_line(int argc, char** argv)
{
  const std::string program = argv[0];
  std::string line = program.substr(program.find_last_of('/') + 1);
  for(int i = 1; i < argc; ++i)
    line += std::string(" ") + argv[i];
  return line;
}

// A progress bar on the standard error stream, or none.
class Progress
{
public:
  Progress(std::size_t steps, bool silent)
  {
    if(!silent)
      display = std::make_unique<boost::timer::progress_display>(steps, std::cerr);
  }

  void step()
  {
    if(display)
      ++*display;
  }

private:
  std::unique_ptr<boost::timer::progress_display> display;
};

// The body of a main function: what goes wrong is said, and is the program's exit status.
template <typename Body>
int report_errors(const Body& body)
{
  try
  {
    body();
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << "error: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_OPTIONS_H
