// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The one place where versions of CGAL are told apart: 5.5 is the floor, 6.x is supported.

#ifndef CGAL_SPIDER_INTERNAL_CGAL_COMPAT_H
#define CGAL_SPIDER_INTERNAL_CGAL_COMPAT_H

#include <CGAL/version.h>

#if CGAL_VERSION_NR < 1050500000
#error "Spider needs CGAL 5.5 or later."
#endif

// CGAL 6.0 added PMP::interpolated_corrected_curvatures().
#if CGAL_VERSION_NR >= 1060000000
#define CGAL_SPIDER_HAS_CORRECTED_CURVATURES 1
#endif

#endif // CGAL_SPIDER_INTERNAL_CGAL_COMPAT_H
