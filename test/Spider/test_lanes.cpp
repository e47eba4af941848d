// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: what several lanes do at once is what each would do alone, to the last bit, on any machine. These tests
// are compiled for the plain architecture, and once more for the machine at hand with all of its instructions.

#include <CGAL/Spider/internal/Lane_indices.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace internal = CGAL::Spider::internal;

namespace {

constexpr int number_of_lanes = internal::number_of_lanes;

template <typename Scalar>
struct lanes : testing::Test
{
  using Values = internal::Lanes<Scalar>;
  using Indices = internal::Lane_indices<Scalar>;

  static std::array<Scalar, number_of_lanes> random_numbers(std::mt19937& random)
  {
    std::array<Scalar, number_of_lanes> numbers;
    for(Scalar& x : numbers)
      x = static_cast<Scalar>(random() % 1000 / 64. - 7.75); // some are alike, some 0
    return numbers;
  }
};

using Scalars = testing::Types<double, float>;

} // namespace

TYPED_TEST_SUITE(lanes, Scalars);

TYPED_TEST(lanes, operations_are_those_of_single_numbers)
{
  using Values = typename TestFixture::Values;
  std::mt19937 random(1);
  for(int repeat = 0; repeat < 100; ++repeat)
  {
    const auto a = TestFixture::random_numbers(random), b = TestFixture::random_numbers(random);
    const Values va(a), vb(b);
    const auto is_less = va < vb, is_not_less = va >= vb;
    bool any = false;
    TypeParam sum = 0;
    for(int l = 0; l < number_of_lanes; ++l)
    {
      EXPECT_EQ((va + vb)[l], a[l] + b[l]);
      EXPECT_EQ((va - vb)[l], a[l] - b[l]);
      EXPECT_EQ((va * vb)[l], a[l] * b[l]);
      EXPECT_EQ((va / (vb * vb + Values(1)))[l], a[l] / (b[l] * b[l] + 1));
      EXPECT_EQ(is_less[l], a[l] < b[l]);
      EXPECT_EQ((is_less & is_not_less)[l], false);
      EXPECT_EQ((is_less | is_not_less)[l], true);
      EXPECT_EQ((!is_less)[l], a[l] >= b[l]);
      EXPECT_EQ(select(is_less, va, vb)[l], std::min(a[l], b[l]));
      EXPECT_EQ(larger(va, vb)[l], std::max(a[l], b[l]));
      EXPECT_EQ(absolute(va)[l], std::abs(a[l]));
      EXPECT_EQ(square_root(absolute(va))[l], std::sqrt(std::abs(a[l])));
      any |= a[l] < b[l];
      sum += a[l];
    }
    EXPECT_EQ(is_less.any(), any);
    EXPECT_EQ(va.sum(), sum); // all numbers are multiples of 1/64, so that sums are exact
  }
}

TYPED_TEST(lanes, a_condition_in_a_single_lane_holds_in_some)
{
  using Values = typename TestFixture::Values;
  EXPECT_FALSE((Values(1) < Values(0)).any());
  for(int l = 0; l < number_of_lanes; ++l)
  {
    Values values(1);
    values.set(l, -1);
    EXPECT_TRUE((values < Values(0)).any());
    auto is_negative = values < Values(0);
    is_negative.set(l, false);
    EXPECT_FALSE(is_negative.any());
    is_negative.set(l, true);
    for(int i = 0; i < number_of_lanes; ++i)
      EXPECT_EQ(is_negative[i], i == l);
  }
}

TYPED_TEST(lanes, numbers_that_are_none_compare_with_nothing)
{
  using Values = typename TestFixture::Values;
  const Values none(std::numeric_limits<TypeParam>::quiet_NaN());
  EXPECT_FALSE((none < Values(0)).any() || (none > Values(0)).any() || (none >= none).any());
}

TYPED_TEST(lanes, places_of_tables_are_looked_up_each)
{
  using Values = typename TestFixture::Values;
  using Indices = typename TestFixture::Indices;
  constexpr std::uint32_t size = 1000;
  constexpr std::uint64_t large = 1u << 31; // negative as a signed number of half the size
  std::vector<TypeParam> numbers;
  std::vector<std::uint64_t> places;
  for(std::uint32_t i = 0; i < size; ++i)
  {
    numbers.push_back(static_cast<TypeParam>(i) / 8);
    places.push_back(i % 3 == 0 ? large + i : i);
  }
  std::mt19937 random(2);
  for(int repeat = 0; repeat < 100; ++repeat)
  {
    Indices at(0);
    for(int l = 0; l < number_of_lanes; ++l)
      at.set(l, random() % (size / 3));
    Values first, second, third;
    internal::gather(numbers.data(), at + at + at, first, second, third);
    const Indices next = internal::gather<Indices>(places.data(), at);
    const auto is_small = next < Indices(1u << 30);
    for(int l = 0; l < number_of_lanes; ++l)
    {
      const std::uint32_t i = at[l];
      EXPECT_EQ(first[l], numbers[3 * i]);
      EXPECT_EQ(second[l], numbers[3 * i + 1]);
      EXPECT_EQ(third[l], numbers[3 * i + 2]);
      EXPECT_EQ(next[l], places[i]);
      EXPECT_EQ(is_small[l], i % 3 != 0);
      EXPECT_EQ(((at & Indices(3)) == Indices(0))[l], i % 4 == 0);
      EXPECT_EQ((at - (at >> 2))[l], i - i / 4);
      EXPECT_EQ(select(is_small, at, next)[l], i % 3 != 0 ? i : places[i]);
    }
  }
}
