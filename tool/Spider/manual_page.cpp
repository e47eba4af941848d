// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"

#include <cctype>
#include <sstream>
#include <string>

namespace CGAL {
namespace Spider {
namespace tool {

namespace {

// returns the text so that man(7) shows it as it is.
std::string verbatim(const std::string& text)
{
  std::string result;
  for(char c : text)
    if(c == '\\')
      result += "\\e";
    else if(c == '-')
      result += "\\-";
    else
      result += c;
  return result.find_first_of(".'") == 0 ? "\\&" + result : result;
}

std::string capitals(std::string text)
{
  for(char& c : text)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

void write_paragraphs(std::ostream& out, const std::string& text)
{
  std::istringstream lines(text);
  for(std::string line; std::getline(lines, line);)
    out << (line.empty() ? ".PP" : verbatim(line)) << '\n';
}

// what the help's end says under unindented headings ending in colons becomes sections
void write_sections(std::ostream& out, const std::string& text)
{
  std::istringstream lines(text);
  bool is_open = false;
  for(std::string line; std::getline(lines, line);)
    if(!line.empty() && line.back() == ':' && line.front() != ' ')
    {
      out << (is_open ? ".fi\n" : "") << ".SH " << capitals(line.substr(0, line.size() - 1)) << "\n.nf\n";
      is_open = true;
    }
    else
      out << verbatim(line) << '\n';
  out << (is_open ? ".fi\n" : "");
}

void write_option(std::ostream& out, const CLI::Option& option)
{
  out << ".TP\n.B " << verbatim(option.get_name(false, true));
  if(option.get_type_size() > 0)
    out << " \\fI" << verbatim(option.get_type_name()) << "\\fR";
  out << '\n';
  write_paragraphs(out, option.get_description());
}

} // namespace

std::string manual_page(const CLI::App& app)
{
  std::ostringstream out;
  const std::string text = app.get_description();
  const std::string first_line = text.substr(0, text.find('\n'));
  out << ".TH SPIDER 1 \"\" \"spider " SPIDER_VERSION "\" \"User Commands\"\n"
      << ".SH NAME\nspider \\- " << verbatim(first_line)
      << "\n.SH SYNOPSIS\n.B spider\n\\fImesh\\fR [\\fIoption\\fR...]\n"
      << ".SH DESCRIPTION\n";
  write_paragraphs(out, text.substr(text.find("\n\n") + 2));
  out << ".SH OPTIONS\n";
  for(const std::string& group : app.get_groups())
  {
    const auto options =
      app.get_options([&](const CLI::Option* o) { return o->get_group() == group && !o->get_positional(); });
    if(group.empty() || options.empty()) // hidden, or that of the mesh
      continue;
    out << ".SS " << verbatim(group) << '\n';
    for(const CLI::Option* option : options)
      write_option(out, *option);
  }
  write_sections(out, app.get_footer());
  return out.str();
}

} // namespace tool
} // namespace Spider
} // namespace CGAL
