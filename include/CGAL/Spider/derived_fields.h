// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Scalars that follow from a curvature estimate: functors, and property maps that apply them to a map of estimates.

#ifndef CGAL_SPIDER_DERIVED_FIELDS_H
#define CGAL_SPIDER_DERIVED_FIELDS_H

#include <CGAL/Spider/Curvature_estimate_3.h>
#include <CGAL/Spider/internal/numbers.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <limits>

namespace CGAL {
namespace Spider {

/// \addtogroup PkgSpiderFields
/// @{

/// returns `Curvature_estimate_3::mean_curvature()`. Models `SpiderField`.
struct Mean_curvature
{
  /// \param e the estimate
  /// \return what the member of that name does
  template <typename GT>
  typename GT::FT operator()(const Curvature_estimate_3<GT>& e) const { return e.mean_curvature(); }
};

/// returns `Curvature_estimate_3::Gaussian_curvature()`. Models `SpiderField`.
struct Gaussian_curvature
{
  /// \param e the estimate
  /// \return what the member of that name does
  template <typename GT>
  typename GT::FT operator()(const Curvature_estimate_3<GT>& e) const { return e.Gaussian_curvature(); }
};

/// returns `Curvature_estimate_3::shape_index()`. Models `SpiderField`.
struct Shape_index
{
  /// \param e the estimate
  /// \return what the member of that name does
  template <typename GT>
  typename GT::FT operator()(const Curvature_estimate_3<GT>& e) const { return e.shape_index(); }
};

/// returns `Curvature_estimate_3::curvedness()`. Models `SpiderField`.
struct Curvedness
{
  /// \param e the estimate
  /// \return what the member of that name does
  template <typename GT>
  typename GT::FT operator()(const Curvature_estimate_3<GT>& e) const { return e.curvedness(); }
};

/// returns the radial curvature (DeCarlo et al. 2003): the normal curvature in the direction in which the surface faces
/// the viewer, which is that of the view vector's tangential part. It is zero along the suggestive contours, and NaN
/// where the surface is seen from straight above.
struct Radial_curvature
{
  /// \param e the estimate
  /// \param view a vector of any kernel and any length, from the point of the estimate to the viewer
  /// \return a number of the unit 1/length
  template <typename GT, typename Vector>
  typename GT::FT operator()(const Curvature_estimate_3<GT>& e, const Vector& view) const
  {
    using FT = typename GT::FT;
    using Direction = internal::Vec3<FT>;
    const Direction v = internal::unit(internal::to_vec3<FT>(view));
    const FT a = v.dot(internal::to_vec3<FT>(e.min_direction)), b = v.dot(internal::to_vec3<FT>(e.max_direction));
    const FT squared_sine = a * a + b * b; // of the angle to the normal
    constexpr FT rounding = std::numeric_limits<FT>::epsilon();
    if(squared_sine <= rounding * rounding)
      return Curvature_estimate_3<GT>::nan();
    return (a * a * e.min_curvature + b * b * e.max_curvature) / squared_sine;
  }
};

/*!
returns a readable property map from vertices to what a functor makes of their estimates, for example
`extract_isolines(tmesh, derived_field(curvature_map, Mean_curvature()), 0, out)`.

\tparam CurvatureMap a model of `ReadablePropertyMap` from vertices to `Curvature_estimate_3`; it is copied, as property
        maps are, so what it refers to has to stay
\tparam Field a model of `SpiderField`

\param curvature_map the estimates
\param field the functor, which is called whenever the map is read

\return a readable property map from vertices to what `field` returns
*/
template <typename CurvatureMap, typename Field>
auto derived_field(CurvatureMap curvature_map, Field field)
{
  using Vertex = typename boost::property_traits<CurvatureMap>::key_type;
  return boost::make_function_property_map<Vertex>(
    [=](const Vertex& v) { return field(get(curvature_map, v)); });
}

/*!
returns a readable property map from vertices to their `Radial_curvature` for a viewer at a point.

\tparam CurvatureMap a model of `ReadablePropertyMap` from vertices to `Curvature_estimate_3`
\tparam VertexPointMap a model of `ReadablePropertyMap` from vertices to points
\tparam Point a point type of any kernel

\param curvature_map the estimates
\param vpm the points of the vertices
\param viewer where the surface is seen from

\return a readable property map from vertices to numbers of the estimates' type, of the unit 1/length
*/
template <typename CurvatureMap, typename VertexPointMap, typename Point>
auto radial_curvature_field(CurvatureMap curvature_map, VertexPointMap vpm, const Point& viewer)
{
  using Vertex = typename boost::property_traits<CurvatureMap>::key_type;
  using FT = typename boost::property_traits<CurvatureMap>::value_type::FT;
  const internal::Vec3<FT> eye = internal::to_vec3<FT>(viewer);
  return boost::make_function_property_map<Vertex>([=](const Vertex& v) {
    return Radial_curvature()(get(curvature_map, v), internal::Vec3<FT>(eye - internal::to_vec3<FT>(get(vpm, v))));
  });
}

/// @}

} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_DERIVED_FIELDS_H
