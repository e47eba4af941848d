// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Values of several limbs that go in lockstep. With GCC and Clang, packs of doubles are vectors of the compiler's own
// vector extension, as wide as the machine's registers, but of four at most: eight are no faster, since what costs is to
// gather the mesh's data. Elsewhere, and for other types, a pack is a single value. The operations are the same, so the
// answers are.

#ifndef CGAL_SPIDER_INTERNAL_LANES_H
#define CGAL_SPIDER_INTERNAL_LANES_H

#include <Eigen/Core>

#include <array>
#include <cstring>
#include <type_traits>

#if defined(__GNUC__)
#define CGAL_SPIDER_FOR_EACH_PACK(I) _Pragma("GCC unroll 8") for(int I = 0; I < number_of_packs; ++I)
#else
#define CGAL_SPIDER_FOR_EACH_PACK(I) for(int I = 0; I < number_of_packs; ++I)
#endif

namespace CGAL {
namespace Spider {
namespace internal {

/// How many limbs go in lockstep: enough to have something to do for some while others wait for memory.
constexpr int number_of_lanes = 8;

template <typename T>
struct Pack
{
  using type = T;
  using Mask = bool;
};

#if defined(__GNUC__)
template <>
struct Pack<double>
{
#if defined(__AVX__)
  static constexpr int bytes = 32;
#else
  static constexpr int bytes = 16;
#endif
  typedef double type __attribute__((vector_size(bytes)));
  typedef long long Mask __attribute__((vector_size(bytes)));
};
#endif

template <typename T>
using Lane_flag = std::conditional_t<std::is_same<typename Pack<T>::Mask, bool>::value, bool, long long>;

/// A condition in each lane.
template <typename T>
struct Lane_mask
{
  using Packed = typename Pack<T>::Mask;
  static constexpr int number_of_packs = static_cast<int>(number_of_lanes * sizeof(T) / sizeof(typename Pack<T>::type));

  Packed packs[number_of_packs];

  /// returns a number in each lane that isn't 0 where the condition holds.
  std::array<Lane_flag<T>, number_of_lanes> values() const
  {
    std::array<Lane_flag<T>, number_of_lanes> values;
    std::memcpy(values.data(), packs, sizeof(packs));
    return values;
  }

  bool operator[](int lane) const { return values()[lane] != 0; }

  bool any() const
  {
    Packed any = packs[0];
    for(int i = 1; i < number_of_packs; ++i)
      any = any | packs[i];
    if constexpr(std::is_same<Packed, bool>::value)
      return any;
    else
    {
      long long bits = 0;
      for(int i = 0; i < number_of_lanes / number_of_packs; ++i)
        bits |= any[i];
      return bits != 0;
    }
  }

  friend Lane_mask operator&(const Lane_mask& a, const Lane_mask& b)
  {
    Lane_mask result;
    CGAL_SPIDER_FOR_EACH_PACK(i)
    result.packs[i] = a.packs[i] & b.packs[i];
    return result;
  }

  friend Lane_mask operator|(const Lane_mask& a, const Lane_mask& b)
  {
    Lane_mask result;
    CGAL_SPIDER_FOR_EACH_PACK(i)
    result.packs[i] = a.packs[i] | b.packs[i];
    return result;
  }

  friend Lane_mask operator!(const Lane_mask& a)
  {
    Lane_mask result;
    CGAL_SPIDER_FOR_EACH_PACK(i)
    result.packs[i] = a.packs[i] == 0;
    return result;
  }

  friend Lane_mask operator==(const Lane_mask& a, const Lane_mask& b)
  {
    Lane_mask result;
    CGAL_SPIDER_FOR_EACH_PACK(i)
    result.packs[i] = a.packs[i] == b.packs[i];
    return result;
  }
};

/// A number in each lane.
template <typename T>
struct Lanes
{
  using Packed = typename Pack<T>::type;
  using Mask = Lane_mask<T>;
  static constexpr int number_of_packs = Mask::number_of_packs;

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
      packs[lane * number_of_packs / number_of_lanes][lane % (number_of_lanes / number_of_packs)] = value;
  }

#define CGAL_SPIDER_LANE_OPERATOR(RESULT, OP)                   \
  friend RESULT operator OP(const Lanes& a, const Lanes& b)     \
  {                                                             \
    RESULT result;                                              \
    CGAL_SPIDER_FOR_EACH_PACK(i)                                \
    result.packs[i] = a.packs[i] OP b.packs[i];                 \
    return result;                                              \
  }
  CGAL_SPIDER_LANE_OPERATOR(Lanes, +)
  CGAL_SPIDER_LANE_OPERATOR(Lanes, -)
  CGAL_SPIDER_LANE_OPERATOR(Lanes, *)
  CGAL_SPIDER_LANE_OPERATOR(Lanes, /)
  CGAL_SPIDER_LANE_OPERATOR(Mask, <)
  CGAL_SPIDER_LANE_OPERATOR(Mask, >)
  CGAL_SPIDER_LANE_OPERATOR(Mask, >=)
#undef CGAL_SPIDER_LANE_OPERATOR

  Lanes& operator+=(const Lanes& a) { return *this = *this + a; }

  friend Lanes select(const Mask& condition, const Lanes& a, const Lanes& b)
  {
    Lanes result;
    CGAL_SPIDER_FOR_EACH_PACK(i)
    result.packs[i] = condition.packs[i] ? a.packs[i] : b.packs[i];
    return result;
  }

  friend Lanes larger(const Lanes& a, const Lanes& b) { return select(a > b, a, b); }
  friend Lanes smaller(const Lanes& a, const Lanes& b) { return select(a < b, a, b); }
  friend Lanes absolute(const Lanes& a) { return select(a < Lanes(0), Lanes(0) - a, a); }

  /// returns square roots as exact as `std::sqrt()`'s, which may set errno and so isn't for vectors: hence Eigen's.
  friend Lanes square_root(const Lanes& a)
  {
    Lanes result;
    CGAL_SPIDER_FOR_EACH_PACK(i)
    {
      Eigen::Array<T, number_of_lanes / number_of_packs, 1> roots;
      std::memcpy(roots.data(), &a.packs[i], sizeof(Packed));
      roots = roots.sqrt();
      std::memcpy(&result.packs[i], roots.data(), sizeof(Packed));
    }
    return result;
  }

  T sum() const
  {
    Packed sum = packs[0];
    for(int i = 1; i < number_of_packs; ++i)
      sum = sum + packs[i];
    if constexpr(std::is_same<Packed, T>::value)
      return sum;
    else
    {
      T total = sum[0];
      for(int i = 1; i < number_of_lanes / number_of_packs; ++i)
        total += sum[i];
      return total;
    }
  }
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LANES_H
