// For Doxygen only: the functions that <CGAL/Spider/parameters.h> makes of its list of names. A test holds the two together.
namespace CGAL {
namespace Spider {
namespace parameters {

/*!
\ingroup PkgSpiderParameters

the length that limbs grow to, in the mesh's units: a positive number, or a model of `SpiderRadiusMap`.

<b>Default:</b> 4 times the mean edge length; in smoothing half of the mean length of the edges around each vertex, and up to three times as much where there is nothing but noise. The one parameter that is worth thought: it is the size of the smallest feature of interest, and \ref choosing_the_radius tells how to choose it. Paper, 2.2 and 2.6.

\param radius the value
\return a chain of named parameters
*/
template <typename T>
auto geodesic_radius(const T& radius);

/*!
\ingroup PkgSpiderParameters

several radii in place of one, as a range of numbers: estimates of curvature become ranges, one for each radius, in their order.

<b>Default:</b> none. With `surface_fit` limbs are walked once, to the largest radius, but for places where normals turn much from one round to the next.

\param radii the range
\return a chain of named parameters
*/
template <typename T>
auto geodesic_radii(const T& radii);

/*!
\ingroup PkgSpiderParameters

by how much limbs are longer along one direction than across it: a model of `ReadablePropertyMap` from vertices to vectors of any kernel; in `suggest_adaptive_radii()`, which finds them, a model of `WritablePropertyMap`.

Along its vector a limb reaches the `geodesic_radius`, across it as many times less as the vector is long, and in between it ends at an ellipse. So no limb reaches farther than the radius. A vector counts by its part in the tangent plane and has no sign; one that isn't longer than 1, or isn't finite, stands for a disc, and lengths above 8 count as 8. `section_fit` refuses longer ones than 1.

<b>Default:</b> none: limbs reach equally far in all directions. Paper, section 4, where it is future work.

\param map the map
\return a chain of named parameters
*/
template <typename T>
auto limb_elongation_map(const T& map);

/*!
\ingroup PkgSpiderParameters

how many directions are spaced regularly over a half turn; each has two limbs.

<b>Default:</b> 2.5 for each mean edge length of the radius, at least 16; with `section_fit` and in tracing 64 (paper, 2.6); in smoothing 16. Time grows linearly with it. Fewer than the default cost accuracy, more gain nothing that was measurable.

\param count the value
\return a chain of named parameters
*/
template <typename T>
auto number_of_directions(const T& count);

/*!
\ingroup PkgSpiderParameters

an `Estimator`: how samples become curvatures.

<b>Default:</b> `surface_fit`. Paper, 2.2 and 2.3, and \ref design for the difference.

\param kind the value
\return a chain of named parameters
*/
template <typename T>
auto estimator(const T& kind);

/*!
\ingroup PkgSpiderParameters

a `Limb_measure`: what is measured along a limb until it reaches the radius.

<b>Default:</b> `tangential_distance` where the estimator is `surface_fit`, else `arc_length` (paper, 2.2). Noise makes arcs longer, so by arc length a spider shrinks under noise.

\param kind the value
\return a chain of named parameters
*/
template <typename T>
auto limb_measure(const T& kind);

/*!
\ingroup PkgSpiderParameters

2, 3 or 4: the degree of the fitted polynomials.

<b>Default:</b> 2 (paper, 2.6). `surface_fit` takes terms up to the fourth degree as far as noise lets, whatever the degree; those up to the degree are interpolated over
facets as the mesh would have them. So under noise 3 and 4 are as good as 2, and on smooth meshes without noise and with small radii far better. They take up to twice the time. With `section_fit` 4 needs
twice the radius under noise.

\param degree the value
\return a chain of named parameters
*/
template <typename T>
auto polynomial_degree(const T& degree);

/*!
\ingroup PkgSpiderParameters

the distance of samples along a limb as a share of the radius, from 0.001 to 1.

<b>Default:</b> 0.1 (paper, 2.6). Of no effect on `surface_fit`, which samples each segment of a limb once.

\param share the value
\return a chain of named parameters
*/
template <typename T>
auto resampling_step(const T& share);

/*!
\ingroup PkgSpiderParameters

in radians: the iteration of the normal rests when it moves by no more.

<b>Default:</b> 0.3; with `section_fit` 0.001. Paper, 2.4. CGAL's own `number_of_iterations()` is the most rounds, 10 by default.

\param angle the value
\return a chain of named parameters
*/
template <typename T>
auto convergence_angle(const T& angle);

/*!
\ingroup PkgSpiderParameters

a `First_normal`: where the iteration of the normal starts if no `vertex_normal_map()` is given.

<b>Default:</b> `neighbourhood`; `sphere_section` after `as_published()` (paper, 2.1).

\param kind the value
\return a chain of named parameters
*/
template <typename T>
auto first_normal(const T& kind);

/*!
\ingroup PkgSpiderParameters

in degrees from 0 to 90: a limb that meets a feature edge at a smaller angle between the edge and its plane goes on.

<b>Default:</b> 30. Paper, 2.5. With `surface_fit` limbs stop at feature edges at any angle. CGAL's own `edge_is_constrained_map()` names the feature edges.

\param angle the value
\return a chain of named parameters
*/
template <typename T>
auto minimum_crossing_angle(const T& angle);

/*!
\ingroup PkgSpiderParameters

a model of `SpiderGrowthCostMap`: by how much length in a face counts.

<b>Default:</b> 1 for all faces. Paper, 2.5.

\param map the value
\return a chain of named parameters
*/
template <typename T>
auto growth_cost_map(const T& map);

/*!
\ingroup PkgSpiderParameters

in 1/length: the largest absolute value of a principal curvature that counts as none for `classify_vertices()`.

<b>Default:</b> three quarters of the mesh's typical curvature. Paper, figure 10.

\param curvature the value
\return a chain of named parameters
*/
template <typename T>
auto flatness_threshold(const T& curvature);

/*!
\ingroup PkgSpiderParameters

from 0 (not itself) to 1: the share of the way to the ring's centroid that a vertex goes in a round of `smooth_by_geodesic_rings()`.

<b>Default:</b> 0.2 (paper, figure 11).

\param share the value
\return a chain of named parameters
*/
template <typename T>
auto smoothing_factor(const T& share);

/*!
\ingroup PkgSpiderParameters

a `Ring_weight`: how the points of a ring count for its centroid.

<b>Default:</b> `by_limb` (paper, 3.1).

\param kind the value
\return a chain of named parameters
*/
template <typename T>
auto ring_weight(const T& kind);

/*!
\ingroup PkgSpiderParameters

a `Line_motion`: what smoothing does to vertices on borders and constrained edges.

<b>Default:</b> `fixed_lines`.

\param kind the value
\return a chain of named parameters
*/
template <typename T>
auto line_motion(const T& kind);

/*!
\ingroup PkgSpiderParameters

whether vertices take back in each round of smoothing what those around them move alike, and a closed mesh encloses as much
after it as at first.

<b>Default:</b> `true`.

\param yes the value
\return a chain of named parameters
*/
template <typename T>
auto keep_volume(const T& yes);

/*!
\ingroup PkgSpiderParameters

in the mesh's units: smoothing ends with the first round in which no vertex moves farther.

<b>Default:</b> 0.

\param length the value
\return a chain of named parameters
*/
template <typename T>
auto convergence_displacement(const T& length);

/*!
\ingroup PkgSpiderParameters

a number that is not negative: `extract_ridges()` leaves out lines of less `Ridge_3::strength`.

<b>Default:</b> 1.

\param strength the value
\return a chain of named parameters
*/
template <typename T>
auto minimum_strength(const T& strength);

/*!
\ingroup PkgSpiderParameters

a number that is not negative: `extract_ridges()` leaves out lines of less `Ridge_3::sharpness`.

<b>Default:</b> 0.5.

\param sharpness the value
\return a chain of named parameters
*/
template <typename T>
auto minimum_sharpness(const T& sharpness);

} // namespace parameters
} // namespace Spider
} // namespace CGAL
