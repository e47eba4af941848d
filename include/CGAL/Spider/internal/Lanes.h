// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Values of several limbs that go in lockstep, in packs. The operations are the same whatever the machine, so the
// answers are, but for the rounding of sums over limbs.

#ifndef CGAL_SPIDER_INTERNAL_LANES_H
#define CGAL_SPIDER_INTERNAL_LANES_H

#include <CGAL/Spider/internal/Pack.h>
#include <CGAL/Spider/internal/unrolled_loops.h>

#include <array>
#include <cstring>
#include <type_traits>

#define CGAL_SPIDER_FOR_EACH_PACK(I) CGAL_SPIDER_FOR_EACH(I, 0, number_of_packs)

/// Defines an operator by what it does in each pack.
#define CGAL_SPIDER_LANE_OPERATOR(RESULT, LANES, OP)        \
  friend RESULT operator OP(const LANES& a, const LANES& b) \
  {                                                         \
    RESULT result;                                          \
    CGAL_SPIDER_FOR_EACH_PACK(i)                            \
      result.packs[i] = a.packs[i] OP b.packs[i];           \
    return result;                                          \
  }

/// Defines a comparison by what it is called for packs.
#define CGAL_SPIDER_LANE_COMPARISON(MASK, LANES, OP, NAME) \
  friend MASK operator OP(const LANES& a, const LANES& b)  \
  {                                                        \
    MASK result;                                           \
    CGAL_SPIDER_FOR_EACH_PACK(i)                           \
      result.packs[i] = NAME(a.packs[i], b.packs[i]);      \
    return result;                                         \
  }

namespace CGAL {
namespace Spider {
namespace internal {

/// How many limbs go in lockstep: as many as one register holds. With more there are too few registers for what a limb
/// carries along.
constexpr int number_of_lanes = sizeof(Pack<double>::type) / sizeof(double);

/// A condition in each lane.
template <typename T>
struct Lane_mask
{
  using Packed = typename Pack<T>::Mask;
  static constexpr int lanes_per_pack = static_cast<int>(sizeof(typename Pack<T>::type) / sizeof(T));
  static constexpr int number_of_packs = number_of_lanes / lanes_per_pack;

  Packed packs[number_of_packs];

  bool operator[](int lane) const
  {
    const Packed& pack = packs[lane / lanes_per_pack];
    if constexpr(std::is_same<Packed, bool>::value)
      return pack;
    else if constexpr(std::is_integral<Packed>::value)
      return (pack >> lane % lanes_per_pack & 1) != 0;
    else
      return pack[lane % lanes_per_pack] != 0;
  }

  void set(int lane, bool value)
  {
    Packed& pack = packs[lane / lanes_per_pack];
    if constexpr(std::is_same<Packed, bool>::value)
      pack = value;
    else if constexpr(std::is_integral<Packed>::value)
      pack = static_cast<Packed>((pack & ~(1 << lane % lanes_per_pack)) | value << lane % lanes_per_pack);
    else
      pack[lane % lanes_per_pack] = value ? -1 : 0;
  }

  bool any() const
  {
    Packed any = packs[0];
    for(int i = 1; i < number_of_packs; ++i)
      any = any | packs[i];
    return is_any(any);
  }

  CGAL_SPIDER_LANE_OPERATOR(Lane_mask, Lane_mask, &)
  CGAL_SPIDER_LANE_OPERATOR(Lane_mask, Lane_mask, |)
  CGAL_SPIDER_LANE_COMPARISON(Lane_mask, Lane_mask, ==, agree)

  friend Lane_mask operator!(const Lane_mask& a)
  {
    constexpr Lane_mask nowhere = {};
    return a == nowhere;
  }
};

/// A number in each lane.
template <typename T>
struct Lanes
{
  using Packed = typename Pack<T>::type;
  using Mask = Lane_mask<T>;
  static constexpr int lanes_per_pack = Mask::lanes_per_pack, number_of_packs = Mask::number_of_packs;

  Packed packs[number_of_packs];

  Lanes() = default;
  Lanes(T value)
  {
    CGAL_SPIDER_FOR_EACH_PACK(i)
      packs[i] = value - Packed{};
  }

  explicit Lanes(const std::array<T, number_of_lanes>& values) { std::memcpy(packs, values.data(), sizeof(packs)); }

  std::array<T, number_of_lanes> values() const
  {
    std::array<T, number_of_lanes> values;
    std::memcpy(values.data(), packs, sizeof(packs));
    return values;
  }

  T operator[](int lane) const { return values()[lane]; }

  void set(int lane, T value)
  {
    if constexpr(std::is_same<Packed, T>::value)
      packs[lane] = value;
    else
      packs[lane / lanes_per_pack][lane % lanes_per_pack] = value;
  }

  CGAL_SPIDER_LANE_OPERATOR(Lanes, Lanes, +)
  CGAL_SPIDER_LANE_OPERATOR(Lanes, Lanes, -)
  CGAL_SPIDER_LANE_OPERATOR(Lanes, Lanes, *)
  CGAL_SPIDER_LANE_OPERATOR(Lanes, Lanes, /)
  CGAL_SPIDER_LANE_COMPARISON(Mask, Lanes, <, is_less)
  CGAL_SPIDER_LANE_COMPARISON(Mask, Lanes, >=, is_at_least)
  friend Mask operator>(const Lanes& a, const Lanes& b) { return b < a; }

  Lanes& operator+=(const Lanes& a) { return *this = *this + a; }

  friend Lanes select(const Mask& condition, const Lanes& a, const Lanes& b)
  {
    Lanes result;
    CGAL_SPIDER_FOR_EACH_PACK(i)
      result.packs[i] = choose(condition.packs[i], a.packs[i], b.packs[i]);
    return result;
  }

  friend Lanes larger(const Lanes& a, const Lanes& b) { return select(a > b, a, b); }
  friend Lanes smaller(const Lanes& a, const Lanes& b) { return select(a < b, a, b); }
  friend Lanes absolute(const Lanes& a) { return select(a < Lanes(0), Lanes(0) - a, a); }

  friend Lanes square_root(const Lanes& a)
  {
    Lanes result;
    CGAL_SPIDER_FOR_EACH_PACK(i)
      result.packs[i] = exact_square_root<T>(a.packs[i]);
    return result;
  }

  T sum() const
  {
    std::array<T, number_of_lanes> sums = values();
    for(int half = number_of_lanes / 2; half > 0; half /= 2)
      for(int l = 0; l < half; ++l)
        sums[l] += sums[l + half];
    return sums[0];
  }
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LANES_H
