// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_FOR_EACH_QUERY_H
#define CGAL_SPIDER_INTERNAL_FOR_EACH_QUERY_H

#include <CGAL/Spider/internal/for_each_chunk.h>
#include <CGAL/Spider/internal/progress.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// calls `store(query, answer)` for every query of a range, in order, with the answers of function objects that
/// `make_worker()` returns. Only these run concurrently, each in one thread at a time and for many queries, so they may
/// keep buffers; what `store` writes to needn't be safe to write to from several threads, and the outcome doesn't depend
/// on their number. Between the blocks that are worked on at once, a visitor is told how much is done.
template <typename ConcurrencyTag, typename Range, typename MakeWorker, typename Store, typename Visitor = Default_visitor>
void for_each_query(const Range& queries, const MakeWorker& make_worker, const Store& store, Visitor visitor = Visitor())
{
  using Query = std::decay_t<decltype(*std::begin(queries))>;
  using Result = std::decay_t<decltype(make_worker()(std::declval<const Query&>()))>;
  constexpr std::size_t chunk_size = 1 << 7;              // many enough to make a worker worth it
  constexpr std::size_t block_size = chunk_size * 1 << 6; // large enough to feed any number of threads, and little memory

  const double number_of_queries = static_cast<double>(std::distance(std::begin(queries), std::end(queries)));
  std::size_t number_of_answers = 0;
  std::vector<Query> block;
  std::vector<Result> results;
  const auto run_block = [&] {
    results.resize(block.size());
    for_each_chunk<ConcurrencyTag>(block.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
      auto&& worker = make_worker();
      for(std::size_t i = begin; i < end; ++i)
        results[i] = worker(block[i]);
    });
    for(std::size_t i = 0; i < block.size(); ++i)
      store(block[i], results[i]);
    number_of_answers += block.size();
    block.clear();
    tell_progress(visitor, number_of_answers / number_of_queries);
  };

  for(const auto& query : queries)
  {
    block.push_back(query);
    if(block.size() == block_size)
      run_block();
  }
  if(!block.empty())
    run_block();
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_FOR_EACH_QUERY_H
