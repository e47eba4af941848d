// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the help and the manual page tell before and after the options.

#ifndef CGAL_SPIDER_TOOL_HELP_TEXTS_H
#define CGAL_SPIDER_TOOL_HELP_TEXTS_H

namespace CGAL {
namespace Spider {
namespace tool {

inline constexpr const char* description =
  R"(Curvature of a triangle mesh, at every vertex, by the spider operator.

From each vertex, lines walk over the surface in all directions until they are as long as the geodesic radius, and
curvature is fitted to what they meet. So the radius is the one choice that matters: it is the size of the smallest
detail that you want to see, and it must be large enough for noise to average out. Begin with --suggest-radius.

Curvature is positive where the surface bends away from its outer side: a ball of radius R has H = 1/R. Its unit is one
over the mesh's unit of length. H is the mean of the principal curvatures k_min and k_max, K their product.)";

inline constexpr const char* examples =
  R"(Examples:
  spider scan.stl --suggest-radius --output scan.ply
      estimates at a radius that suits the scan and its noise; MeshLab, ParaView and Blender show the file in colour
  spider scan.stl --geodesic-radius 0.5 --output scan.csv
      one line per vertex, for a spreadsheet or for Python
  spider scan.ply --radius-in-edges 2,4,8 --output scan.vtp
      three radii, in mean edge lengths: H_r2a, H_r4a and H_r8a
  spider part.off --feature-angle 40 --output part.vtp --picture part.png
      patches apart at edges that turn by more than 40 degrees, and a picture
  spider head.obj --labels --isolines H=0,k_max=0.2 --isolines-output lines.obj --output head.ply
      convex, concave, flat and saddle vertices, and two kinds of lines
  spider head.obj --radius-in-edges 6 --ridges ridges.vtp
      where the surface bends most: ridges and valleys, with their strength and sharpness
  spider noisy.off --smooth 10 --mesh-output smooth.off
      noise off the mesh itself
  spider scan.stl --json --quiet | jq '.runs[0].H.median'
      for scripts

Exit status:
  0  all went well
  1  the mesh can't be read, or isn't one that has curvature: what is wrong is said in one line
  2  wrong usage: an unknown option, or a value out of its range
  3  a file can't be written, or a picture can't be rendered
  4  anything else)";

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_HELP_TEXTS_H
