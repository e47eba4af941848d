// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "render.h"

#include "tool_types.h"

#define BOOST_DLL_USE_STD_FS // or it would take Boost's own file system, which has to be linked with
#include <boost/dll/runtime_symbol_info.hpp>

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

// returns the text as one word for the shell.
std::string quoted(const std::string& text)
{
  std::string result = "'";
  for(char c : text)
    result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

std::string triple(const std::vector<double>& vector)
{
  std::ostringstream text;
  text << vector[0] << ',' << vector[1] << ',' << vector[2];
  return text.str();
}

} // namespace

void render(const std::string& vtp_file, const std::string& colour_by, const Picture_settings& picture)
{
  const std::filesystem::path program =
    std::filesystem::path(boost::dll::program_location().string()).parent_path() / "spider-picture";
  if(!std::filesystem::exists(program))
    throw File_error(picture.file, "can't be rendered: there is no " + program.string());
  const std::string command = quoted(program.string()) + " --field=" + quoted(colour_by) +
                              " --view=" + triple(picture.view) + " --up=" + triple(picture.up) + ' ' +
                              quoted(vtp_file) + ' ' + quoted(picture.file);
  if(std::system(command.c_str()) != 0)
    throw File_error(picture.file, "can't be rendered, for the reason given above");
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
