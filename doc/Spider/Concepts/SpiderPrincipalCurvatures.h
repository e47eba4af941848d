/*!
\class SpiderPrincipalCurvatures "" ""
\ingroup PkgSpiderConcepts

What `CGAL::Spider::classify_vertices()` reads: a record with two curvatures, Spider's or another's.

\cgalConcept

\cgalHasModel
- `CGAL::Spider::Curvature_estimate_3`
- `CGAL::Polygon_mesh_processing::Principal_curvatures_and_directions` of CGAL 6, whose signs are the same
*/
class SpiderPrincipalCurvatures
{
public:
  /// a type of numbers
  typedef unspecified_type FT;

  FT min_curvature; ///< the smaller principal curvature; a vertex where it isn't finite stays without a label
  FT max_curvature; ///< the larger principal curvature
};
