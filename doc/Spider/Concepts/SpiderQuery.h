/*!
\class SpiderQuery "" ""
\ingroup PkgSpiderConcepts

A point on a mesh at which something is estimated or traced.

\cgalConcept

\cgalHasModel
- `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, and whatever converts to it: a vertex. If it has no face, it is
  isolated, and there is nothing to estimate.
- `CGAL::Polygon_mesh_processing::Face_location<TriangleMesh, FT>`: a face, and the barycentric coordinates of a point in
  it, with any number type. `CGAL::Polygon_mesh_processing::locate()` finds the one that is nearest to a point in space.
  The coordinates must not be negative and must sum to one, up to 10⁻⁶. A location at a corner of its face is that
  vertex. Where one is on a feature edge, it belongs to the patch of its face.
*/
class SpiderQuery
{
};
