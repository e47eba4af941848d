// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The promise: the samples at limbs' ends lie where limbs got, not beyond, have the slopes of the faces there, and come
// to other faces little by little.

#include <CGAL/Spider/internal/Limb_ends.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

namespace internal = CGAL::Spider::internal;
using Values = internal::Lanes<double>;

/// The end of a limb, with one function beside the height.
class End
{
  using Ends = internal::Limb_ends<double, 2>;
  static constexpr double stretch = 0.1;

public:
  End() { ends_.clear({Values(0), Values(0)}); }

  /// leads on in a face that the limb leaves at y = `exit`, with the function and the height there. A limb that ends
  /// there before takes but a share of the way.
  void follow(double exit, double function, double height, double share = 1)
  {
    const internal::Lane_points<double> nowhere{};
    const auto on_the_way = [=](double from, double to) { return from + share * (to - from); };
    const double y = on_the_way(y_, exit), gain = std::max(y - farthest_, 0.);
    function = on_the_way(function_, function);
    height = on_the_way(height_, height);
    ends_.follow({nowhere, nowhere, 0, share, gain, 0, 0, y_, exit}, {function_, height_}, {function, height}, stretch);
    y_ = y;
    farthest_ = std::max(farthest_, y);
    function_ = function;
    height_ = height;
  }

  double y() const { return ends_.y_and_slope(0)[0]; }
  double slope_of_y() const { return ends_.y_and_slope(1)[0] - y(); }
  double function() const { return ends_.function_and_slope(0, 0)[0]; }
  double slope() const { return ends_.function_and_slope(0, 1)[0] - function(); }
  double share_of(double to_reach) const { return ends_.share_of(to_reach)[0]; }

private:
  Ends ends_;
  double y_ = 0, farthest_ = 0, function_ = 0, height_ = 0;
};

} // namespace

TEST(limb_ends, are_where_limbs_got_with_the_slopes_of_the_faces_there)
{
  End end;
  end.follow(0.5, 1, 0);
  EXPECT_NEAR(end.y(), 0.5, 1e-12);
  EXPECT_NEAR(end.slope(), 2, 1e-12);
  End enters = end; // another face, by four tenths of what counts fully
  enters.follow(0.9, 1, 0, 0.1);
  EXPECT_NEAR(enters.y(), 0.5 + 0.4 * 0.04, 1e-12);
  EXPECT_NEAR(enters.function(), 1, 1e-12);
  EXPECT_NEAR(enters.slope(), 0.6 * 2, 1e-12);
  end.follow(0.9, 1, 0);
  end.follow(0.7, 5, 0); // turns back
  EXPECT_NEAR(end.y(), 0.9, 1e-12);
  EXPECT_NEAR(end.function(), 1, 1e-12);
  EXPECT_NEAR(end.slope(), 0, 1e-12);
  EXPECT_NEAR(end.share_of(0.9), 1, 1e-12);
  EXPECT_NEAR(end.share_of(0.9 / 0.95), 0.5, 1e-12);
  EXPECT_EQ(end.share_of(1.1), 0);
}

TEST(limb_ends, take_half_of_the_slopes_of_faces_that_fall_by_45_degrees)
{
  End end;
  end.follow(0.5, 1, 0);
  end.follow(0.8, 1, -0.3);
  EXPECT_NEAR(end.slope(), 1, 1e-12);
}

TEST(limb_ends, keep_linear_functions_linear_and_never_lie_beyond_the_limb)
{
  std::mt19937 random(5);
  const auto uniform = [&] { return random() / 4294967296.; };
  for(int limb = 0; limb < 100; ++limb)
  {
    End end;
    double y = 0, farthest = 0;
    for(int i = 0; i < 12; ++i)
    {
      y += 0.3 * uniform() - 0.1;
      const bool is_last = i == 11;
      farthest = std::max(farthest, y);
      end.follow(y, 3 * y, 0.4 * uniform() - 0.2, is_last ? uniform() : 1);
      EXPECT_LE(end.y(), farthest + 1e-12);
      EXPECT_NEAR(end.function(), 3 * end.y(), 1e-12);
      EXPECT_NEAR(end.slope(), 3 * end.slope_of_y(), 1e-12);
    }
  }
}
