// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What holds limbs up besides the end of the mesh (paper, 2.5): feature edges, and what an attribute of the faces
// costs.

#ifndef CGAL_SPIDER_INTERNAL_GROWTH_ATTRIBUTES_H
#define CGAL_SPIDER_INTERNAL_GROWTH_ATTRIBUTES_H

#include <CGAL/Spider/internal/check_parameter.h>
#include <CGAL/Spider/internal/numbers.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spider {
namespace internal {

template <typename T>
constexpr bool is_given = !std::is_same<std::decay_t<T>, CGAL::internal_np::Param_not_found>::value;

/// Which of the faces around a point on a feature edge are around it.
enum Star_extent
{
  whole_star,   ///< all of them: limbs may start in each
  patch_of_star ///< those of one smooth patch, to whose surface an estimate belongs
};

/// The caller's property maps, or `Param_not_found` where there is none.
template <typename FeatureMap = CGAL::internal_np::Param_not_found,
          typename CostMap = CGAL::internal_np::Param_not_found>
class Growth_attributes
{
public:
  static constexpr bool has_features = is_given<FeatureMap>;
  static constexpr bool has_costs = is_given<CostMap>;

  explicit Growth_attributes(const FeatureMap& features = {}, const CostMap& costs = {},
                             Star_extent extent = whole_star)
    : features_(features), costs_(costs), star_extent_(extent)
  {}

  Star_extent star_extent() const { return star_extent_; }

  template <typename Edge>
  bool is_feature(const Edge& e) const
  {
    if constexpr(has_features)
      return get(features_, e);
    else
      return false;
  }

  /// returns by how much length in a face counts, at least 1; infinite where limbs stop.
  template <typename Scalar, typename Face>
  Scalar cost(const Face& f) const
  {
    if constexpr(has_costs)
    {
      const Scalar cost = to_scalar<Scalar>(get(costs_, f));
      check_parameter(cost >= 1, "growth_cost_map", cost, "give every face a cost of at least 1, or infinity");
      return cost;
    }
    else
      return Scalar(1);
  }

private:
  FeatureMap features_;
  CostMap costs_;
  Star_extent star_extent_;
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_GROWTH_ATTRIBUTES_H
