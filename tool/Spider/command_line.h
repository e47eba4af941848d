// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_COMMAND_LINE_H
#define CGAL_SPIDER_TOOL_COMMAND_LINE_H

#include "Settings.h"

#include <CLI/CLI.hpp>

namespace CGAL {
namespace Spider {
namespace tool {

// What the program ends with.
enum Exit_code
{
  success = 0,
  unusable_mesh = 1,
  wrong_usage = 2,
  unwritten_file = 3, // or no picture
  other_failure = 4
};

// describes the program and adds all of its options; `settings` are filled when the application parses.
void describe_command_line(CLI::App& app, Settings& settings);

// returns what the command line says of itself as a manual page, in the macros of man(7).
std::string manual_page(const CLI::App& app);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_COMMAND_LINE_H
