// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What `surface_fit` does where the surface ends on one side, at borders and feature edges.
//
// - A spider there sees half a disc, and from the tip of a ragged border less than that. So another one is grown from
//   near the middle of what the first one saw, and what it finds is told for the query point. It doesn't see farther
//   than the first one could: its limbs end where they are at the radius from the query point.
// - On part of a disc all terms of a height field disturb each other, not only those that turn alike with the angle. So
//   all up to the fourth degree are fitted, and those above the quadratic ones are expected to be as large as curvature
//   lets expect: without noise that is the whole quartic fit, and with much noise the quadric.

#ifndef CGAL_SPIDER_INTERNAL_ONE_SIDED_FIT_H
#define CGAL_SPIDER_INTERNAL_ONE_SIDED_FIT_H

#include <CGAL/Spider/internal/Options.h>
#include <CGAL/Spider/internal/Reached_area.h>
#include <CGAL/Spider/internal/Sampled_spider.h>
#include <CGAL/Spider/internal/Site_ahead.h>
#include <CGAL/Spider/internal/height_field.h>

namespace CGAL {
namespace Spider {
namespace internal {

template <typename View>
class One_sided_fit
{
  using Scalar = typename View::Scalar;
  static constexpr int degree = 4;

public:
  /// returns which share a one-sided fit gets of the answer where that much is cut off of a spider: nothing where
  /// nothing is, and all from a twentieth on, which a straight border cuts off that is 0.7 radii away. Measured: were
  /// it from a fifth on, half a radius from a border there would be three times the error without noise, and 7 % less
  /// with.
  static Scalar share(Scalar cut_off)
  {
    constexpr Scalar clearly_cut = Scalar(0.05);
    return 1 - falling(cut_off, Scalar(0), clearly_cut);
  }

  /// returns what there is at the site in the units of the radius, given what a spider there reached; undetermined
  /// where it isn't better known than by that spider.
  Local_field<Scalar> operator()(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame,
                                 Scalar radius, const Reached_area<Scalar>& area, const Options<Scalar>& options)
  {
    const Vec3<Scalar> query = grow_inside(view, site, frame, radius, area, options);
    if(!(spider_.extent(0).reached > 0))
      return {};
    return spider_.fit(0).at(query.x(), query.y());
  }

private:
  /// grows a spider near the middle of the area that the one at the site reached, within the radius of the site, and
  /// returns where that is in the coordinates of the spider. If that in turn sees little, since limbs lead out of a tip
  /// by a narrow way only, it goes on from there.
  Vec3<Scalar> grow_inside(const View& view, const Site<View>& site, const Spider_frame<Scalar>& frame, Scalar radius,
                           Reached_area<Scalar> area, const Options<Scalar>& options)
  {
    // From the middle, limbs see into the tips of a ragged border; but it is curvature at the site that is wanted.
    // Measured: at 0.3, with noise, there is up to a tenth more error, and at 0 up to two thirds.
    constexpr Scalar share_of_way = Scalar(0.7);
    constexpr int most_steps = 4;
    constexpr Scalar fair = Scalar(0.5), little = Scalar(0.75); // of the limbs' length is cut off
    Site<View> inside = site;
    Vec3<Scalar> query = Vec3<Scalar>::Zero();
    Scalar share_of_step = 1;
    for(int i = 0; i < most_steps && share_of_step > 0; ++i)
    {
      const auto step = area.centroid();
      const Scalar length = step.norm(), distance = share_of_way * share_of_step * length * radius;
      constexpr Scalar least_length = Scalar(1e-6); // below, the direction is that of rounding
      if(length > least_length && distance > 0)
        inside = site_ahead(view, inside, frame, step.x() / length, step.y() / length, distance);
      query = Local_coordinates<Scalar>(inside.point, frame, radius)(site.point);
      spider_.grow_in_disc(view, inside, frame, radius, query.x(), query.y(), options);
      area = spider_.area(0);
      share_of_step = 1 - falling(area.cut_off(), fair, little);
    }
    return query;
  }

  Sampled_spider<View, degree> spider_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_ONE_SIDED_FIT_H
