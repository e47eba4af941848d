// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_GROWTH_LIMIT_H
#define CGAL_SPIDER_INTERNAL_GROWTH_LIMIT_H

namespace CGAL {
namespace Spider {
namespace internal {

/// How far a limb gets when length counts as many times as the face costs that it is in: length and surcharges together
/// are at most the radius, 1 unless said. `Value` is a number, or several in lanes.
template <typename Value>
class Growth_limit
{
public:
  /// returns what the measure will say where the limb ends, should that be in this face; the radius if no face costs
  /// more than 1.
  const Value& limit() const { return limit_; }

  /// returns the cost of this face.
  const Value& cost() const { return cost_; }

  /// enters a face of a finite cost when the measure says `reached`.
  void enter(const Value& cost, const Value& reached)
  {
    surcharge_ = surcharge_ + (cost_ - Value(1)) * (reached - entered_at_);
    entered_at_ = reached;
    cost_ = cost;
    find_limit();
  }

  /// has the limb end at another radius.
  void set_radius(const Value& radius)
  {
    radius_ = radius;
    find_limit();
  }

private:
  // exactly the radius as long as faces cost 1
  void find_limit() { limit_ = (radius_ - surcharge_ + (cost_ - Value(1)) * entered_at_) / cost_; }

  Value limit_ = Value(1), radius_ = Value(1), cost_ = Value(1), entered_at_ = Value(0);
  Value surcharge_ = Value(0); ///< what all faces before this one cost beyond length
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_GROWTH_LIMIT_H
