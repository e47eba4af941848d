/*!
\class SpiderCurvatureResult "" ""
\ingroup PkgSpiderConcepts

What `CGAL::Spider::estimate_vertex_curvatures()` can write into: the value type of the caller's property map.

\cgalConcept

\cgalHasModel
- `CGAL::Spider::Curvature_estimate_3` of any kernel with floating-point numbers, the mesh's or another

A type of your own that keeps a single number of each estimate saves the memory of the others.
*/
class SpiderCurvatureResult
{
public:
  /*!
  keeps what it wants of an estimate. May be explicit.
  \tparam GT the kernel of the results: that of the mesh's points where its numbers are floating-point, else
  `CGAL::Simple_cartesian<double>`
  \param estimate the estimate
  */
  template <typename GT>
  SpiderCurvatureResult(const CGAL::Spider::Curvature_estimate_3<GT>& estimate);
};
