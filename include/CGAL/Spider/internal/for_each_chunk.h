// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_FOR_EACH_CHUNK_H
#define CGAL_SPIDER_INTERNAL_FOR_EACH_CHUNK_H

#include <CGAL/for_each.h>
#include <CGAL/tags.h>

#include <boost/range/counting_range.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Spider {
namespace internal {

/// calls `work(begin, end)` for consecutive parts of the numbers 0 to n - 1, which may run concurrently.
template <typename ConcurrencyTag, typename Work>
void for_each_chunk(std::size_t n, std::size_t chunk_size, const Work& work)
{
  const std::size_t number_of_chunks = (n + chunk_size - 1) / chunk_size;
  CGAL::for_each<ConcurrencyTag>(boost::counting_range(std::size_t(0), number_of_chunks), [&](std::size_t chunk) {
    work(chunk * chunk_size, std::min((chunk + 1) * chunk_size, n));
    return true;
  });
}

/// calls `work(i)` for the numbers 0 to n - 1, which may run concurrently: for work that takes less than a microsecond.
template <typename ConcurrencyTag, typename Work>
void for_each_number(std::size_t n, const Work& work)
{
  constexpr std::size_t chunk_size = 1 << 12; // a task of TBB's takes about a microsecond to start
  for_each_chunk<ConcurrencyTag>(n, chunk_size, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      work(i);
  });
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_FOR_EACH_CHUNK_H
