// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: classes of vertices by the length of edges, as many as that varies, and numbers in between.

#include <CGAL/Spider/internal/by_density.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace internal = CGAL::Spider::internal;

namespace {

/// returns lengths from 1 to `ratio`, evenly spaced by their logarithms.
std::vector<double> lengths_up_to(double ratio, int count)
{
  std::vector<double> lengths;
  for(int i = 0; i < count; ++i)
    lengths.push_back(std::pow(ratio, double(i) / (count - 1)));
  return lengths;
}

} // namespace

TEST(by_density, there_is_a_class_for_each_time_that_lengths_double)
{
  // nine tenths of four octaves are 3.6, since a twentieth at each end doesn't count
  const auto classes = internal::density_classes(lengths_up_to(16, 1000), 1, 100);
  ASSERT_EQ(classes.size(), 4u);
  for(std::size_t i = 0; i < classes.size(); ++i)
  {
    EXPECT_EQ(classes[i].begin, 250 * i);
    EXPECT_EQ(classes[i].end, 250 * (i + 1));
    EXPECT_NEAR(std::log2(classes[i].edge_length), i + 0.5, 4. / 1000); // the spacing of lengths
  }
}

TEST(by_density, classes_are_wider_where_asked_and_never_too_small)
{
  EXPECT_EQ(internal::density_classes(lengths_up_to(16, 1000), 2, 100).size(), 2u);
  EXPECT_EQ(internal::density_classes(lengths_up_to(16, 1000), 1, 400).size(), 2u);
  EXPECT_EQ(internal::density_classes(lengths_up_to(1, 1000), 1, 100).size(), 1u);
  EXPECT_EQ(internal::density_classes(lengths_up_to(16, 10), 1, 400).size(), 1u);
  EXPECT_TRUE(internal::density_classes(std::vector<double>(), 1, 100).empty());
}

TEST(by_density, lengths_of_all_sizes_make_eight_classes)
{
  std::vector<double> lengths(500, std::numeric_limits<double>::min());
  lengths.insert(lengths.end(), 500, std::numeric_limits<double>::max());
  EXPECT_EQ(internal::density_classes(lengths, 1, 10).size(), 8u);
}

TEST(by_density, numbers_are_interpolated_by_logarithms_and_kept_beyond_the_ends)
{
  internal::Table_by_density<double> table;
  EXPECT_TRUE(table.empty());
  table.add(1, 3);
  table.add(4, 48);
  EXPECT_FALSE(table.empty());
  EXPECT_NEAR(table(2), 12, 1e-14); // rounding
  EXPECT_NEAR(table(1), 3, 1e-14);
  EXPECT_EQ(table(0.5), 3);
  EXPECT_EQ(table(4), 48);
  EXPECT_EQ(table(100), 48);
}

TEST(by_density, what_is_nothing_at_an_end_is_nothing_up_to_the_next)
{
  internal::Table_by_density<double> table;
  table.add(1, 0);
  table.add(4, 2);
  EXPECT_EQ(table(2), 0);
  EXPECT_EQ(table(4), 2);
}
