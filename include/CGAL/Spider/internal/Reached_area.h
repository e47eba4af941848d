// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_REACHED_AREA_H
#define CGAL_SPIDER_INTERNAL_REACHED_AREA_H

#include <CGAL/Spider/Limb_3.h>
#include <CGAL/Spider/internal/numbers.h>

#include <Eigen/Core>

namespace CGAL {
namespace Spider {
namespace internal {

/// The area that a spider's limbs reached, limb by limb, in units of the radius: how much of it borders and feature
/// edges cut off, and to which side of the query point the rest lies.
template <typename Scalar>
class Reached_area
{
public:
  using Vector = Eigen::Matrix<Scalar, 2, 1>;

  /// adds a limb that got so far of what it was to reach.
  void add(Scalar reached, Scalar to_reach, Limb_end end, Scalar cosine, Scalar sine)
  {
    to_reach_ += to_reach;
    if(end == border || end == feature_edge)
      cut_off_ += to_reach - reached;
    area_ += reached * reached / 2;
    moment_ += reached * reached * reached / 3 * Vector(cosine, sine);
  }

  /// returns which share of the limbs' length is missing beyond borders and feature edges.
  Scalar cut_off() const { return to_reach_ > 0 ? cut_off_ / to_reach_ : Scalar(0); }

  Vector centroid() const { return area_ > 0 ? Vector(moment_ / area_) : Vector(Vector::Zero()); }

private:
  Scalar to_reach_ = 0, cut_off_ = 0, area_ = 0;
  Vector moment_ = Vector::Zero();
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_REACHED_AREA_H
