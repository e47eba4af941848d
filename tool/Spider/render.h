// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_RENDER_H
#define CGAL_SPIDER_TOOL_RENDER_H

#include "Settings.h"

#include <string>

namespace CGAL {
namespace Spider {
namespace tool {

// has a VTP file rendered by the program spider-picture, which is beside this one; throws File_error if that fails or
// can't be found. It is a program of its own, in Python, since Python's VTK is a small package of the system's while
// building on VTK's C++ libraries takes hundreds of megabytes, for a picture that many never ask for.
void render(const std::string& vtp_file, const std::string& colour_by, const Picture_settings& picture);

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_RENDER_H
