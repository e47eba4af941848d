// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_READ_NUMBERS_H
#define CGAL_SPIDER_TOOL_READ_NUMBERS_H

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// All of these throw std::invalid_argument, with one line for whoever named the file.

// returns the numbers in a text file, infinity (inf) among them.
std::vector<double> read_numbers(const std::string& file);

// returns the numbers under a name in a CSV file, whose first line has the names.
std::vector<double> read_column(const std::string& file, const std::string& name);

// returns the whole numbers from 0 to below `end` in a text file.
std::vector<std::size_t> read_indices(const std::string& file, std::size_t end);

// refuses numbers that aren't one for each of what the mesh has `count` of.
void check_count(const std::string& file, const std::vector<double>& numbers, std::size_t count,
                 const std::string& of_what);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_READ_NUMBERS_H
