// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

std::ifstream opened(const std::string& file)
{
  std::ifstream in(file);
  if(!in)
    throw std::invalid_argument(file + ": can't be opened");
  return in;
}

// A stream's own numbers don't include infinity.
double number(const std::string& word, const std::string& file)
{
  char* end;
  const double value = std::strtod(word.c_str(), &end);
  while(*end == ' ' || *end == '\r')
    ++end;
  if(word.empty() || *end != '\0')
    throw std::invalid_argument(file + ": " + (word.empty() ? "nothing" : word) + " is no number");
  return value;
}

std::vector<std::string> cells(std::string line)
{
  if(!line.empty() && line.back() == '\r')
    line.pop_back();
  std::vector<std::string> words;
  std::istringstream in(line);
  for(std::string word; std::getline(in, word, ',');)
    words.push_back(word);
  return words;
}

} // namespace

std::vector<double> read_numbers(const std::string& file)
{
  std::ifstream in = opened(file);
  std::vector<double> numbers;
  for(std::string word; in >> word;)
    numbers.push_back(number(word, file));
  return numbers;
}

std::vector<double> read_column(const std::string& file, const std::string& name)
{
  std::ifstream in = opened(file);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = cells(line);
  const auto column = std::distance(names.begin(), std::find(names.begin(), names.end(), name));
  if(column == std::distance(names.begin(), names.end()))
    throw std::invalid_argument(file + ": has no column " + name + " in its first line");
  std::vector<double> numbers;
  while(std::getline(in, line))
  {
    std::vector<std::string> words = cells(line);
    words.resize(names.size());
    numbers.push_back(number(words[column], file));
  }
  return numbers;
}

std::vector<std::size_t> read_indices(const std::string& file, std::size_t end)
{
  std::vector<std::size_t> indices;
  for(double number : read_numbers(file))
  {
    if(!(number >= 0 && number < static_cast<double>(end)) || number != std::floor(number))
    {
      std::ostringstream reason;
      reason << file << ": " << number << " is no vertex: give whole numbers from 0 to " << end - 1;
      throw std::invalid_argument(reason.str());
    }
    indices.push_back(static_cast<std::size_t>(number));
  }
  return indices;
}

void check_count(const std::string& file, const std::vector<double>& numbers, std::size_t count,
                 const std::string& of_what)
{
  if(numbers.size() != count)
    throw std::invalid_argument(file + ": has " + std::to_string(numbers.size()) + " numbers for a mesh of " +
                                std::to_string(count) + " " + of_what + ": give one for each");
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
