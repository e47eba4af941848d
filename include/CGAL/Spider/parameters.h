// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_PARAMETERS_H
#define CGAL_SPIDER_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Spider {

/// \ingroup PkgSpiderParameters
/// How the samples of a spider become principal curvatures.
enum Estimator
{
  surface_fit, ///< one height field fitted to the samples of all limbs at once
  section_fit  ///< one polynomial per direction, then the orthogonal pair of greatest difference (paper, 2.2 and 2.3)
};

/// \ingroup PkgSpiderParameters
/// What is measured along a limb until it reaches the geodesic radius.
enum Limb_measure
{
  arc_length,         ///< the length of the polyline (paper, 2.2)
  tangential_distance ///< the distance gained along the limb's direction, which noise doesn't lengthen
};

/// \ingroup PkgSpiderParameters
/// Where the iteration of the normal starts.
enum First_normal
{
  incident_faces, ///< the sum of the incident faces' area vectors
  neighbourhood,  ///< face area vectors averaged over a neighbourhood that grows with the radius
  sphere_section  ///< the best-fit plane of the mesh's intersection with a sphere (paper, 2.1)
};

/// \ingroup PkgSpiderParameters
/// How the points of a geodesic ring count for its centroid.
enum Ring_weight
{
  by_limb, ///< each as much (paper, 3.1)
  by_arc   ///< by the length of the ring that it stands for
};

/// \ingroup PkgSpiderParameters
/// What smoothing does to vertices on lines: borders, and constrained edges.
enum Line_motion
{
  fixed_lines,  ///< they stay where they are
  sliding_lines ///< they spread out along their lines, but for those where lines end, meet or turn a corner
};

/// Every named parameter that is Spider's own; CGAL's names follow them in a chain.
#define CGAL_SPIDER_FOR_EACH_PARAMETER(DO) \
  DO(geodesic_radius)                      \
  DO(geodesic_radii)                       \
  DO(limb_elongation_map)                  \
  DO(number_of_directions)                 \
  DO(estimator)                            \
  DO(limb_measure)                         \
  DO(polynomial_degree)                    \
  DO(resampling_step)                      \
  DO(convergence_angle)                    \
  DO(first_normal)                         \
  DO(minimum_crossing_angle)               \
  DO(growth_cost_map)                      \
  DO(flatness_threshold)                   \
  DO(smoothing_factor)                     \
  DO(ring_weight)                          \
  DO(line_motion)                          \
  DO(keep_volume)                          \
  DO(convergence_displacement)             \
  DO(minimum_strength)                     \
  DO(minimum_sharpness)

namespace internal_np {

using namespace CGAL::internal_np;

#define CGAL_SPIDER_TAG(NAME) \
  enum NAME##_t               \
  {                           \
    NAME                      \
  };
CGAL_SPIDER_FOR_EACH_PARAMETER(CGAL_SPIDER_TAG)
#undef CGAL_SPIDER_TAG

} // namespace internal_np

/*!
\ingroup PkgSpiderParameters

A pack of named parameters that Spider's own names can be chained to. CGAL's names may follow, after which the pack is
CGAL's: `parameters::geodesic_radius(r).number_of_directions(32).geom_traits(k)`.

\tparam T the type of the last parameter's value
\tparam Tag what tells the parameter from others
\tparam Base the pack of the parameters before it
*/
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  /// CGAL's pack of the same parameters
  using Pack = CGAL::Named_function_parameters<T, Tag, Base>;
  using Pack::Pack;

#define CGAL_SPIDER_MEMBER(NAME)                                                  \
  template <typename K>                                                           \
  Named_parameters<K, Spider::internal_np::NAME##_t, Pack> NAME(const K& k) const \
  {                                                                               \
    return {k, *this};                                                            \
  }
  CGAL_SPIDER_FOR_EACH_PARAMETER(CGAL_SPIDER_MEMBER)
#undef CGAL_SPIDER_MEMBER
};

namespace parameters {

using namespace CGAL::parameters;

#define CGAL_SPIDER_FUNCTION(NAME)                                   \
  template <typename K>                                              \
  Named_parameters<K, Spider::internal_np::NAME##_t> NAME(const K& k) \
  {                                                                  \
    return {k};                                                      \
  }
CGAL_SPIDER_FOR_EACH_PARAMETER(CGAL_SPIDER_FUNCTION)
#undef CGAL_SPIDER_FUNCTION

/*!
\ingroup PkgSpiderParameters

starts a chain with the settings of the paper (2.6): `section_fit` with quadratics along 64 directions, resampled at a
tenth of the radius, from the normal of the sphere's section, iterated at most ten times. What is chained to it
overrides it, CGAL's `number_of_iterations()` included: the paper uses one round where normals are reliable.

\return a pack of named parameters
*/
inline auto as_published()
{
  return estimator(section_fit)
    .number_of_directions(64u)
    .limb_measure(arc_length)
    .polynomial_degree(2u)
    .resampling_step(0.1)
    .first_normal(sphere_section);
}

} // namespace parameters
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_PARAMETERS_H
