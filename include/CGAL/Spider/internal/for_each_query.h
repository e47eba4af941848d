// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_FOR_EACH_QUERY_H
#define CGAL_SPIDER_INTERNAL_FOR_EACH_QUERY_H

#include <CGAL/for_each.h>
#include <CGAL/tags.h>

#include <boost/range/counting_range.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// calls `store(query, compute(query))` for every query of a range, in order. Only `compute` runs concurrently, so what
/// `store` writes to needn't be safe to write to from several threads, and the outcome doesn't depend on their number.
template <typename ConcurrencyTag, typename Range, typename Compute, typename Store>
void for_each_query(const Range& queries, const Compute& compute, const Store& store)
{
  using Query = std::decay_t<decltype(*std::begin(queries))>;
  using Result = decltype(compute(std::declval<const Query&>()));
  constexpr std::size_t block_size = 1 << 13; // large enough to feed any number of threads, and little memory

  std::vector<Query> block;
  std::vector<Result> results;
  const auto run_block = [&] {
    results.resize(block.size());
    CGAL::for_each<ConcurrencyTag>(boost::counting_range(std::size_t(0), block.size()), [&](std::size_t i) {
      results[i] = compute(block[i]);
      return true;
    });
    for(std::size_t i = 0; i < block.size(); ++i)
      store(block[i], results[i]);
    block.clear();
  };

  for(const auto& query : queries)
  {
    block.push_back(query);
    if(block.size() == block_size)
      run_block();
  }
  run_block();
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_FOR_EACH_QUERY_H
