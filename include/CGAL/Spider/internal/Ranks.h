// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_RANKS_H
#define CGAL_SPIDER_INTERNAL_RANKS_H

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// The ranks of a mesh's vertices or faces in the order of descriptors, whatever indices the mesh has or lacks. Where
/// descriptors are indices without gaps, they are their own ranks, and nothing is stored.
template <typename Descriptor>
class Ranks
{
public:
  template <typename Range>
  explicit Ranks(const Range& descriptors)
  {
    if constexpr(are_indices)
    {
      const auto is_own_rank = [this](Descriptor d) { return static_cast<std::size_t>(d) == size_++; };
      are_own_ranks_ = std::all_of(descriptors.begin(), descriptors.end(), is_own_rank);
    }
    if(are_own_ranks_)
      return;
    sorted_.assign(descriptors.begin(), descriptors.end());
    size_ = sorted_.size();
    if(!std::is_sorted(sorted_.begin(), sorted_.end()))
      std::sort(sorted_.begin(), sorted_.end());
  }

  std::size_t size() const { return size_; }

  Descriptor operator[](std::size_t rank) const
  {
    if constexpr(are_indices)
      if(are_own_ranks_)
        return Descriptor(rank);
    return sorted_[rank];
  }

  /// returns the rank, or `size()` for what isn't of the mesh.
  std::size_t operator()(Descriptor d) const
  {
    if constexpr(are_indices)
      if(are_own_ranks_)
        return std::min(static_cast<std::size_t>(d), size_);
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), d);
    return found != sorted_.end() && *found == d ? static_cast<std::size_t>(found - sorted_.begin()) : size_;
  }

private:
  static constexpr bool are_indices =
    std::is_convertible<Descriptor, std::size_t>::value && std::is_constructible<Descriptor, std::size_t>::value;

  std::size_t size_ = 0;
  bool are_own_ranks_ = false;
  std::vector<Descriptor> sorted_; ///< none if they are their own ranks
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_RANKS_H
