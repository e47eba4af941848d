// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_TOOL_FOR_EACH_VERTEX_H
#define CGAL_SPIDER_TOOL_FOR_EACH_VERTEX_H

#include "tool_types.h"

#include <CGAL/Real_timer.h>
#include <CGAL/for_each.h>
#include <CGAL/tags.h>

#include <boost/range/counting_range.hpp>
#include <boost/timer/progress_display.hpp>

#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Spider {
namespace tool {

// calls worker(v) for every vertex, on all cores where TBB is there, under a bar that shows how far the work is, unless
// that has no title; workers are made by make_worker(), each for one thread and many vertices. Returns the seconds that
// it took.
template <typename MakeWorker>
double for_each_vertex(const std::vector<Vertex>& vertices, const std::string& title, const MakeWorker& make_worker)
{
  constexpr std::size_t vertices_per_worker = 128; // enough to make a worker worth it
  // as many parts as the bar has ticks
  constexpr std::size_t number_of_parts = 50;

  std::optional<boost::timer::progress_display> progress;
  if(!title.empty())
    progress.emplace(vertices.size(), std::cerr, title + "\n");
  CGAL::Real_timer timer;
  timer.start();
  for(std::size_t part = 0; part < number_of_parts; ++part)
  {
    const std::size_t begin = part * vertices.size() / number_of_parts;
    const std::size_t end = (part + 1) * vertices.size() / number_of_parts;
    const std::size_t number_of_workers = (end - begin + vertices_per_worker - 1) / vertices_per_worker;
    const auto numbers = boost::counting_range(std::size_t(0), number_of_workers);
    CGAL::for_each<CGAL::Parallel_if_available_tag>(numbers, [&](std::size_t number) {
      auto worker = make_worker();
      const std::size_t first = begin + number * vertices_per_worker, last = std::min(first + vertices_per_worker, end);
      for(std::size_t i = first; i < last; ++i)
        worker(vertices[i]);
      return true; // CGAL's word for: go on
    });
    if(progress)
      *progress += end - begin;
  }
  return timer.time();
}

} // namespace tool
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_TOOL_FOR_EACH_VERTEX_H
