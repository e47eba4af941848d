// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops over a few, known numbers, that compilers are asked to write out: they keep values in registers then, which with
// loops inside loops they don't do by themselves.

#ifndef CGAL_SPIDER_INTERNAL_UNROLLED_LOOPS_H
#define CGAL_SPIDER_INTERNAL_UNROLLED_LOOPS_H

#if defined(__GNUC__)
#define CGAL_SPIDER_FOR_EACH(I, BEGIN, END) _Pragma("GCC unroll 16") for(int I = BEGIN; I < END; ++I)
#else
#define CGAL_SPIDER_FOR_EACH(I, BEGIN, END) for(int I = BEGIN; I < END; ++I)
#endif

#endif // CGAL_SPIDER_INTERNAL_UNROLLED_LOOPS_H
