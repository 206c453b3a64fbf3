#include "python/bindings.h"
#include "python/struct_class.h"
#include "recon/contour_residual.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/mesh_quality.h"
#include "recon/metrics/slice_agreement.h"
#include "recon/surface/retriangulate.h"

namespace isostack::python {

namespace {

void bind_mesh_results(py::module_& core) {
  using M = MeshMeasures;
  StructClass<M>(core, "MeshMeasures", "What a surface is, in numbers.\n")
      .result("volume_mm3", &M::volume_mm3, "signed: negative for a mesh turned inside out, mm³")
      .result("area_mm2", &M::area_mm2, "mm²")
      .result("vertices", &M::vertices, "vertices")
      .result("triangles", &M::triangles, "triangles")
      .result("components", &M::components, "connected through shared vertices")
      .result("euler_characteristic", &M::euler_characteristic, "vertices − edges + triangles")
      .result("genus", &M::genus, "components − χ/2; meaningful when closed and manifold")
      .result("boundary_edges", &M::boundary_edges, "edges with one triangle")
      .result("non_manifold_edges", &M::non_manifold_edges, "edges with more than two triangles")
      .result("flipped_edges", &M::flipped_edges, "edges whose two triangles disagree about the outside")
      .done_as_result()
      .def_property_readonly("watertight", &M::watertight, "closed, manifold, and of one mind about the outside");
  using Q = MeshQuality;
  StructClass<Q>(core, "MeshQuality", "How even the triangles of a mesh are.\n")
      .result("shortest_edge_mm", &Q::shortest_edge_mm, "mm")
      .result("edge_percentile5_mm", &Q::edge_percentile5_mm, "mm")
      .result("median_edge_mm", &Q::median_edge_mm, "mm")
      .result("edge_percentile95_mm", &Q::edge_percentile95_mm, "mm")
      .result("longest_edge_mm", &Q::longest_edge_mm, "mm")
      .result("smallest_angle_deg", &Q::smallest_angle_deg, "of all corners, degrees")
      .result("mean_smallest_angle_deg", &Q::mean_smallest_angle_deg, "of the triangles' smallest angles, degrees")
      .result("corners_below_20_deg", &Q::corners_below_20_deg, "corners")
      .done_as_result();
}

}  // namespace

void bind_agreement(py::module_& core) {
  bind_mesh_results(core);
  using S = SliceAgreement;
  StructClass<S>(core, "SliceAgreement", "How contours agree with those they should be, over several slices.\n")
      .result("slices", &S::slices, "compared")
      .result("one_sided", &S::one_sided, "slices on which only one of the two has contours: only Dice sees them")
      .result("missed", &S::missed, "contours of the truth farther than their own width from all that was found")
      .result("dice", &S::dice, "2|A∩B| / (|A|+|B|), over pixels")
      .result("has_distances", &S::has_distances, "False: the distances mean nothing")
      .result("mean_mm", &S::mean_mm, "mean of the two directions' means, mm")
      .result("percentile95_mm", &S::percentile95_mm, "larger of the two directions' 95 % quantiles, mm")
      .result("largest_mm", &S::largest_mm, "larger of the two directions' largest, mm")
      .done_as_result();
  using R = ContourResidual;
  StructClass<R>(core, "ContourResidual", "How far contour points are from the surface.\n")
      .result("mean_mm", &R::mean_mm, "mm")
      .result("percentile95_mm", &R::percentile95_mm, "mm")
      .result("largest_mm", &R::largest_mm, "mm")
      .result("worst_slice", &R::worst_slice, "of the farthest point, an index into the stack")
      .done_as_result();
  using T = RetriangulationOptions;
  StructClass<T>(core, "RetriangulationOptions", "What a surface's triangles are to be like; by default as they are.\n")
      .field("edge_length_mm", &T::edge_length_mm, "isotropic remeshing with edges of this length, mm; 0: none")
      .field("simplify_tolerance_mm", &T::simplify_tolerance_mm,
             "fewer triangles, at most this far from the surface as it was, mm; 0: none")
      .field("triangles", &T::triangles, "fewer triangles, down to this many; 0: none")
      .done();
  using P = RetriangulationReport;
  StructClass<P>(core, "RetriangulationReport", "What came of retriangulation.\n")
      .result("triangles_before", &P::triangles_before, "triangles")
      .result("triangles_after", &P::triangles_after, "triangles")
      .result("mean_distance_mm", &P::mean_distance_mm, "between the surface before and after, both ways, mm")
      .result("largest_distance_mm", &P::largest_distance_mm, "the same, mm")
      .result("vertices_off_surface", &P::vertices_off_surface, "vertices without a root near them")
      .result("quality", &P::quality, "afterwards")
      .result("seconds", &P::seconds, "s")
      .done_as_result();
}

}  // namespace isostack::python
