/*!
\class SpiderGrowthCostMap "" ""
\ingroup PkgSpiderConcepts

What length in a face costs, for the parameter `CGAL::Spider::parameters::growth_cost_map()`: limbs get shorter where it is
dear (paper, 2.5).

\cgalRefines{ReadablePropertyMap}

\cgalConcept

\cgalHasModel
- any readable property map from faces to numbers, of `Surface_mesh` for example, or by `boost::make_function_property_map()`

`get(map, face)` is called for every face that a limb enters, from several threads at once with a parallel tag; batches read it
once for each face.
*/
class SpiderGrowthCostMap
{
public:
  /// the mesh's face descriptor
  typedef unspecified_type key_type;

  /// a type of numbers. Every value is at least 1: a limb that goes the length l in the face uses up the value times l of its radius.
  /// Infinity stops limbs. A value below 1, or NaN, is a `std::invalid_argument`.
  typedef unspecified_type value_type;
};
