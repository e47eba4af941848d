/*!
\class SpiderRadiusMap "" ""
\ingroup PkgSpiderConcepts

A geodesic radius for each vertex, for the parameter `CGAL::Spider::parameters::geodesic_radius()`.
`CGAL::Spider::suggest_geodesic_radii()` fills one in.

\cgalRefines{ReadablePropertyMap}

\cgalConcept

\cgalHasModel
- any readable property map from vertices to numbers

Between vertices, at a `Face_location`, the radius is interpolated.
*/
class SpiderRadiusMap
{
public:
  /// the mesh's vertex descriptor
  typedef unspecified_type key_type;

  /// a type of numbers: lengths in the mesh's units. A vertex whose radius isn't positive, NaN among them, gets an estimate that is
  /// `CGAL::Spider::insufficient`.
  typedef unspecified_type value_type;
};
