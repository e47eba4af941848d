// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_SAMPLES_H
#define CGAL_SPIDER_INTERNAL_SAMPLES_H

#include <CGAL/Spider/internal/walk_limb.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// calls `sample(share)` for the points of a segment where the measure, which goes from `from` to `to` along it, reaches a
/// further multiple of `step`; `count` is the number of multiples reached so far.
template <typename Scalar, typename Sample>
void sample_segment(Scalar from, Scalar to, Scalar step, std::size_t& count, Sample&& sample)
{
  for(Scalar at = Scalar(count + 1) * step; at <= to; at = Scalar(count + 1) * step)
  {
    sample(to > from ? (at - from) / (to - from) : Scalar(1));
    ++count;
  }
}

/// tells whether a polyline's end is worth a sample of its own, the last regular one being at rounding's distance of it.
template <typename Scalar>
bool end_is_apart(Scalar length, Scalar step, std::size_t count)
{
  constexpr Scalar same = Scalar(1e-9); // far above the rounding of a walk's length, far below any step
  return length - Scalar(count) * step > (count == 0 ? Scalar(0) : same * step);
}

/// A sample of a limb in the plane of its cut, in units of the radius: `y` along the direction, `z` along the normal.
template <typename Scalar>
struct Sample
{
  Scalar y, z;
};

/// walks a limb and appends its samples at regular measure, its end included, the query point not (paper, 2.2).
/// `sign` is -1 for the limb that runs against the direction in whose coordinates the samples are wanted.
template <typename View>
Walk_result<View> sample_limb(const View& view,
                              const Site<View>& site,
                              const Cut<typename View::Scalar>& cut,
                              const Limb_rule<typename View::Scalar>& rule,
                              typename View::Scalar resampling_step,
                              int sign,
                              std::vector<Sample<typename View::Scalar>>& samples)
{
  using Scalar = typename View::Scalar;
  Scalar y = 0, z = 0, reached = 0;
  Sample<Scalar> end{0, 0}; // where most was reached: a limb may turn back before it ends
  std::size_t count = 0;
  const Walk_result<View> result = walk_limb(view, site, cut, rule, [&](const Step<View>& step) {
    sample_segment(step.from, step.to, resampling_step, count, [&](Scalar share) {
      samples.push_back({sign * (y + share * (step.y - y)), z + share * (step.z - z)});
    });
    y = step.y;
    z = step.z;
    if(step.to >= reached)
    {
      reached = step.to;
      end = {sign * y, z};
    }
  });
  if(end_is_apart(reached, resampling_step, count))
    samples.push_back(end);
  return result;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_SAMPLES_H
