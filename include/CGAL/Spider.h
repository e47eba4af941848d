// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_H
#define CGAL_SPIDER_H

#include <CGAL/Spider/Curvature_estimate_3.h>
#include <CGAL/Spider/Curvature_estimator.h>
#include <CGAL/Spider/Isoline_3.h>
#include <CGAL/Spider/Limb_3.h>
#include <CGAL/Spider/Ridge_3.h>
#include <CGAL/Spider/classify_vertices.h>
#include <CGAL/Spider/derived_fields.h>
#include <CGAL/Spider/estimate_curvature.h>
#include <CGAL/Spider/estimate_curvatures.h>
#include <CGAL/Spider/estimate_normal.h>
#include <CGAL/Spider/estimate_normal_curvature.h>
#include <CGAL/Spider/estimate_vertex_curvatures.h>
#include <CGAL/Spider/estimate_vertex_normals.h>
#include <CGAL/Spider/extract_isolines.h>
#include <CGAL/Spider/extract_ridges.h>
#include <CGAL/Spider/geodesic_ring.h>
#include <CGAL/Spider/parameters.h>
#include <CGAL/Spider/resample.h>
#include <CGAL/Spider/smooth_by_geodesic_rings.h>
#include <CGAL/Spider/suggest_adaptive_radii.h>
#include <CGAL/Spider/suggest_geodesic_radius.h>
#include <CGAL/Spider/trace_limb.h>
#include <CGAL/Spider/trace_limbs.h>
#include <CGAL/Spider/trace_sphere_section.h>

#endif // CGAL_SPIDER_H
