/*!
\class SpiderField "" ""
\ingroup PkgSpiderConcepts

A functor that makes one value of an estimate, for `CGAL::Spider::derived_field()`. It is copied.

\cgalConcept

\cgalHasModel
- `CGAL::Spider::Mean_curvature`
- `CGAL::Spider::Gaussian_curvature`
- `CGAL::Spider::Shape_index`
- `CGAL::Spider::Curvedness`
- any lambda that takes an estimate
*/
class SpiderField
{
public:
  /*!
  may be called from several threads at once.
  \tparam GT the kernel of the estimates
  \param estimate an estimate, which may be invalid: then its numbers are NaN
  \return a value of any type; a number, where isolines are to be extracted
  */
  template <typename GT>
  unspecified_type operator()(const CGAL::Spider::Curvature_estimate_3<GT>& estimate) const;
};
