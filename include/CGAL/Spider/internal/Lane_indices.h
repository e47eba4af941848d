// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_LANE_INDICES_H
#define CGAL_SPIDER_INTERNAL_LANE_INDICES_H

#include <CGAL/Spider/internal/Lanes.h>
#include <CGAL/Spider/internal/read_packs.h>

#include <array>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Spider {
namespace internal {

/// A place in a table in each lane, beside values of type `T`. Places are as wide as those, so that the same conditions
/// hold of both.
template <typename T>
struct Lane_indices
{
  using Packed = typename Pack<T>::Indices;
  using Mask = Lane_mask<T>;
  static constexpr int number_of_packs = Mask::number_of_packs;

  Packed packs[number_of_packs];

  Lane_indices() = default;
  Lane_indices(std::uint32_t index)
  {
    CGAL_SPIDER_FOR_EACH_PACK(i)
      packs[i] = static_cast<long long>(index) - Packed{};
  }

  std::uint32_t operator[](int lane) const { return static_cast<std::uint32_t>(values()[lane]); }

  void set(int lane, std::uint32_t index)
  {
    auto indices = values();
    indices[lane] = index;
    std::memcpy(packs, indices.data(), sizeof(packs));
  }

  CGAL_SPIDER_LANE_OPERATOR(Lane_indices, Lane_indices, +)
  CGAL_SPIDER_LANE_OPERATOR(Lane_indices, Lane_indices, -)
  CGAL_SPIDER_LANE_OPERATOR(Lane_indices, Lane_indices, &)
  CGAL_SPIDER_LANE_COMPARISON(Mask, Lane_indices, <, is_less)
  CGAL_SPIDER_LANE_COMPARISON(Mask, Lane_indices, ==, is_equal)

  friend Lane_indices operator>>(const Lane_indices& a, int bits)
  {
    Lane_indices result;
    CGAL_SPIDER_FOR_EACH_PACK(i)
      result.packs[i] = a.packs[i] >> bits;
    return result;
  }

  friend Lane_indices select(const Mask& condition, const Lane_indices& a, const Lane_indices& b)
  {
    Lane_indices result;
    CGAL_SPIDER_FOR_EACH_PACK(i)
      result.packs[i] = choose(condition.packs[i], a.packs[i], b.packs[i]);
    return result;
  }

  std::array<long long, number_of_lanes> values() const
  {
    std::array<long long, number_of_lanes> values;
    std::memcpy(values.data(), packs, sizeof(packs));
    return values;
  }
};

/// returns what a table has at given places, as `Lane_indices`.
template <typename Result, typename Element, typename T>
Result gather(const Element* table, const Lane_indices<T>& at)
{
  Result result;
  constexpr int number_of_packs = Result::number_of_packs;
  CGAL_SPIDER_FOR_EACH_PACK(i)
    read(table, at.packs[i], result.packs[i]);
  return result;
}

/// gathers three numbers that follow one another in a table, from given places on.
template <typename T>
void gather(const T* table, const Lane_indices<T>& at, Lanes<T>& a, Lanes<T>& b, Lanes<T>& c)
{
  constexpr int number_of_packs = Lanes<T>::number_of_packs;
  CGAL_SPIDER_FOR_EACH_PACK(i)
    read(table, at.packs[i], a.packs[i], b.packs[i], c.packs[i]);
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LANE_INDICES_H
