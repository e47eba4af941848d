// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What machines do with several numbers at once. With GCC and Clang, packs of doubles are vectors of the compiler's own
// vector extension, as wide as the machine's registers. Elsewhere, and for other types, a pack is a single value. What
// the extension has no operators for is written twice: portably, and for the machines that have an instruction.

#ifndef CGAL_SPIDER_INTERNAL_PACK_H
#define CGAL_SPIDER_INTERNAL_PACK_H

#include <Eigen/Core>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <cstddef>
#include <cstring>
#include <type_traits>

// Packs of eight doubles have masks of their own, and of four at least tables that are read at several places at once.
#if defined(__GNUC__) && defined(__AVX512F__) && defined(__AVX512DQ__)
#define CGAL_SPIDER_HAS_PACKS_OF_8
#elif defined(__GNUC__) && defined(__AVX2__)
#define CGAL_SPIDER_HAS_PACKS_OF_4
#endif
#if defined(CGAL_SPIDER_HAS_PACKS_OF_8) || defined(CGAL_SPIDER_HAS_PACKS_OF_4)
#define CGAL_SPIDER_HAS_WIDE_PACKS
#endif

namespace CGAL {
namespace Spider {
namespace internal {

/// Several numbers, what may hold of each, and as many places in tables.
template <typename T>
struct Pack
{
  using type = T;
  using Mask = bool;
  using Indices = long long;
};

#if defined(__GNUC__)
template <>
struct Pack<double>
{
#if defined(CGAL_SPIDER_HAS_PACKS_OF_8)
  static constexpr int bytes = 64;
#elif defined(CGAL_SPIDER_HAS_PACKS_OF_4)
  static constexpr int bytes = 32;
#else
  static constexpr int bytes = 16;
#endif
  typedef double type __attribute__((vector_size(bytes)));
  typedef long long Indices __attribute__((vector_size(bytes)));
#if defined(CGAL_SPIDER_HAS_PACKS_OF_8)
  using Mask = unsigned char; ///< a bit for each
#else
  using Mask = Indices; ///< all bits of each
#endif
};
#endif

// What may hold of numbers in packs, and what is taken where it holds.

template <typename Packed>
using Mask_of = std::conditional_t<std::is_arithmetic<Packed>::value, bool, typename Pack<double>::Mask>;

template <typename Packed>
Mask_of<Packed> is_less(const Packed& a, const Packed& b)
{
  return (Mask_of<Packed>)(a < b);
}

template <typename Packed>
Mask_of<Packed> is_at_least(const Packed& a, const Packed& b)
{
  return (Mask_of<Packed>)(a >= b);
}

template <typename Packed>
Mask_of<Packed> is_equal(const Packed& a, const Packed& b)
{
  return (Mask_of<Packed>)(a == b);
}

/// returns where two conditions both hold or both don't: bit by bit, since narrow registers can't compare longer
/// numbers.
template <typename Mask>
Mask agree(const Mask& a, const Mask& b)
{
  if constexpr(std::is_same<Mask, bool>::value)
    return a == b;
  else
    return static_cast<Mask>(~(a ^ b));
}

template <typename Mask, typename Packed>
Packed choose(const Mask& condition, const Packed& a, const Packed& b)
{
  if constexpr(std::is_integral<Mask>::value)
    return condition ? a : b;
  else
    return (Packed)(((Mask)a & condition) | ((Mask)b & ~condition)); // `?:` would compare the condition with 0 first
}

// Comparisons are by their names, since GCC 12 makes wrong code of `a < b` beside `a >= b` where it combines them.

#if defined(CGAL_SPIDER_HAS_PACKS_OF_4)

inline Pack<double>::Mask is_less(const Pack<double>::type& a, const Pack<double>::type& b)
{
  return (Pack<double>::Mask)_mm256_cmp_pd((__m256d)a, (__m256d)b, _CMP_LT_OQ);
}

inline Pack<double>::Mask is_at_least(const Pack<double>::type& a, const Pack<double>::type& b)
{
  return (Pack<double>::Mask)_mm256_cmp_pd((__m256d)a, (__m256d)b, _CMP_GE_OQ);
}

#elif defined(__GNUC__) && defined(__SSE2__) && !defined(CGAL_SPIDER_HAS_PACKS_OF_8)

inline Pack<double>::Mask is_less(const Pack<double>::type& a, const Pack<double>::type& b)
{
  return (Pack<double>::Mask)_mm_cmplt_pd((__m128d)a, (__m128d)b);
}

inline Pack<double>::Mask is_at_least(const Pack<double>::type& a, const Pack<double>::type& b)
{
  return (Pack<double>::Mask)_mm_cmpge_pd((__m128d)a, (__m128d)b);
}

#endif

#if defined(CGAL_SPIDER_HAS_PACKS_OF_8)

inline Pack<double>::Mask is_less(const Pack<double>::type& a, const Pack<double>::type& b)
{
  return _mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_LT_OQ);
}

inline Pack<double>::Mask is_at_least(const Pack<double>::type& a, const Pack<double>::type& b)
{
  return _mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_GE_OQ);
}

inline Pack<double>::Mask is_less(const Pack<double>::Indices& a, const Pack<double>::Indices& b)
{
  return _mm512_cmplt_epi64_mask((__m512i)a, (__m512i)b);
}

inline Pack<double>::Mask is_equal(const Pack<double>::Indices& a, const Pack<double>::Indices& b)
{
  return _mm512_cmpeq_epi64_mask((__m512i)a, (__m512i)b);
}

inline Pack<double>::type choose(const Pack<double>::Mask& condition, const Pack<double>::type& a,
                                 const Pack<double>::type& b)
{
  return (Pack<double>::type)_mm512_mask_blend_pd(condition, (__m512d)b, (__m512d)a);
}

inline Pack<double>::Indices choose(const Pack<double>::Mask& condition, const Pack<double>::Indices& a,
                                    const Pack<double>::Indices& b)
{
  return (Pack<double>::Indices)_mm512_mask_blend_epi64(condition, (__m512i)b, (__m512i)a);
}

#endif

/// tells whether a condition holds in any lane of a pack.
template <typename Mask>
bool is_any(const Mask& mask)
{
  if constexpr(std::is_integral<Mask>::value)
    return mask != 0;
  else
  {
    long long bits = 0;
    for(std::size_t i = 0; i < sizeof(Mask) / sizeof(bits); ++i)
      bits |= mask[i];
    return bits != 0;
  }
}

#if defined(CGAL_SPIDER_HAS_PACKS_OF_4)
inline bool is_any(const Pack<double>::Mask& mask) { return _mm256_movemask_pd((__m256d)mask) != 0; }
#endif

/// returns square roots as exact as `std::sqrt()`'s, which may set errno and so isn't for vectors: hence Eigen's, whose
/// roots of eight numbers aren't exact.
template <typename T>
typename Pack<T>::type exact_square_root(const typename Pack<T>::type& a)
{
  typename Pack<T>::type roots;
  Eigen::Array<T, sizeof(a) / sizeof(T), 1> values;
  std::memcpy(values.data(), &a, sizeof(a));
  values = values.sqrt();
  std::memcpy(&roots, values.data(), sizeof(a));
  return roots;
}

#if defined(CGAL_SPIDER_HAS_PACKS_OF_8)
template <>
inline Pack<double>::type exact_square_root<double>(const Pack<double>::type& a)
{
  return (Pack<double>::type)_mm512_maskz_sqrt_pd(0xff, (__m512d)a);
}
#endif

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_PACK_H
