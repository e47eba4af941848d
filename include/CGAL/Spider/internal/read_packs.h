// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Places of a table are read one by one, but for machines that read several at once. Of doubles, three that follow one
// another are read at a time, and then change places: the rows of a matrix become its columns.

#ifndef CGAL_SPIDER_INTERNAL_READ_PACKS_H
#define CGAL_SPIDER_INTERNAL_READ_PACKS_H

#include <CGAL/Spider/internal/Pack.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace CGAL {
namespace Spider {
namespace internal {

template <typename Element, typename Indices>
void read(const Element* table, const Indices& at, Indices& elements)
{
  if constexpr(std::is_integral<Indices>::value)
    elements = static_cast<Indices>(table[at]);
  else
    for(std::size_t i = 0; i < sizeof(Indices) / sizeof(at[0]); ++i)
      elements[i] = static_cast<long long>(table[at[i]]);
}

template <typename T, typename Indices, typename Packed>
void read(const T* table, const Indices& at, Packed& first, Packed& second, Packed& third)
{
  if constexpr(std::is_integral<Indices>::value)
  {
    first = table[at];
    second = table[at + 1];
    third = table[at + 2];
  }
  else
    for(std::size_t i = 0; i < sizeof(Indices) / sizeof(at[0]); ++i)
    {
      first[i] = table[at[i]];
      second[i] = table[at[i] + 1];
      third[i] = table[at[i] + 2];
    }
}

#if defined(CGAL_SPIDER_HAS_PACKS_OF_8)

inline void read(const std::uint64_t* table, const Pack<double>::Indices& at, Pack<double>::Indices& elements)
{
  elements = (Pack<double>::Indices)_mm512_mask_i64gather_epi64(_mm512_setzero_si512(), 0xff, (__m512i)at, table, 8);
}

inline void read(const double* table, const Pack<double>::Indices& at, Pack<double>::type& first,
                 Pack<double>::type& second, Pack<double>::type& third)
{
  // As in all of this, what takes a mask: without one, GCC 12 warns of its own undefined values.
  constexpr unsigned char all = 0xff, three = 7;
  alignas(sizeof(at)) long long place[8];
  std::memcpy(place, &at, sizeof(at));
  const auto rows = [&](int i) { // i and i + 4
    return _mm512_maskz_insertf64x4(all, _mm512_castpd256_pd512(_mm256_maskz_loadu_pd(three, table + place[i])),
                                    _mm256_maskz_loadu_pd(three, table + place[i + 4]), 1);
  };
  const __m512d a = rows(0), b = rows(1), c = rows(2), d = rows(3);
  const __m512d ab = _mm512_maskz_unpacklo_pd(all, a, b), cd = _mm512_maskz_unpacklo_pd(all, c, d); // firsts and thirds
  const __m512d ab_second = _mm512_maskz_unpackhi_pd(all, a, b), cd_second = _mm512_maskz_unpackhi_pd(all, c, d);
  const __m512i firsts = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i thirds = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  first = (Pack<double>::type)_mm512_permutex2var_pd(ab, firsts, cd);
  second = (Pack<double>::type)_mm512_permutex2var_pd(ab_second, firsts, cd_second);
  third = (Pack<double>::type)_mm512_permutex2var_pd(ab, thirds, cd);
}

#elif defined(CGAL_SPIDER_HAS_PACKS_OF_4)

inline void read(const std::uint64_t* table, const Pack<double>::Indices& at, Pack<double>::Indices& elements)
{
  elements = (Pack<double>::Indices)_mm256_mask_i64gather_epi64(
    _mm256_setzero_si256(), reinterpret_cast<const long long*>(table), (__m256i)at, _mm256_set1_epi64x(-1), 8);
}

inline void read(const double* table, const Pack<double>::Indices& at, Pack<double>::type& first,
                 Pack<double>::type& second, Pack<double>::type& third)
{
  const __m256i three = _mm256_setr_epi64x(-1, -1, -1, 0);
  const auto row = [&](int i) { return _mm256_maskload_pd(table + at[i], three); };
  const __m256d a = row(0), b = row(1), c = row(2), d = row(3);
  const __m256d ab = _mm256_unpacklo_pd(a, b), cd = _mm256_unpacklo_pd(c, d); // the first and the third of each
  constexpr int lower_halves = 0x20, upper_halves = 0x31;
  first = (Pack<double>::type)_mm256_permute2f128_pd(ab, cd, lower_halves);
  second = (Pack<double>::type)_mm256_permute2f128_pd(_mm256_unpackhi_pd(a, b), _mm256_unpackhi_pd(c, d), lower_halves);
  third = (Pack<double>::type)_mm256_permute2f128_pd(ab, cd, upper_halves);
}

#endif

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_READ_PACKS_H
