#include "python/arrays.h"
#include "python/bindings.h"
#include "python/struct_class.h"
#include "recon/metrics/compare.h"
#include "recon/metrics/contour_measures.h"
#include "recon/metrics/frame_quality.h"
#include "recon/metrics/input_sections.h"
#include "recon/metrics/mesh_curvature.h"
#include "recon/metrics/mesh_quality.h"
#include "recon/metrics/overlap.h"
#include "recon/metrics/voxel_surface.h"
#include "recon/metrics/voxelize.h"
#include "recon/surface/plane_section.h"

namespace isostack::python {

namespace {

const py::call_guard<py::gil_scoped_release> unlocked;

void bind_results(py::module_& core) {
  using D = SurfaceDistance;
  StructClass<D>(core, "SurfaceDistance", "Distances over samples drawn uniformly by area from both surfaces.\n")
      .result("mean_mm", &D::mean_mm, "mean of the two directions' means, mm")
      .result("percentile95_mm", &D::percentile95_mm, "larger of the two directions' 95 % quantiles, mm")
      .result("largest_mm", &D::largest_mm, "larger of the two directions' largest (Hausdorff), mm")
      .done_as_result();
  using B = BodyComparison;
  StructClass<B>(core, "BodyComparison", "The first body against the second.\n")
      .result("dice", &B::dice, "on the labels' grid, or one of about 200 voxels along the diagonal round both")
      .result("distance", &B::distance, "between the surfaces")
      .result("diagonal_mm", &B::diagonal_mm, "of the box round the second, mm")
      .result("volume_difference_mm3", &B::volume_difference_mm3, "first minus second, mm³")
      .result("area_difference_mm2", &B::area_difference_mm2, "first minus second, mm²; None with labels")
      .done_as_result();
  using C = ContourMeasures;
  StructClass<C>(core, "ContourMeasures", "What a plane figure is, in numbers. Curvature is positive where convex.\n")
      .result("area_mm2", &C::area_mm2, "mm²")
      .result("perimeter_mm", &C::perimeter_mm, "mm")
      .result("components", &C::components, "outer curves")
      .result("holes", &C::holes, "holes")
      .result("lowest_curvature_per_mm", &C::lowest_curvature_per_mm, "1/mm")
      .result("highest_curvature_per_mm", &C::highest_curvature_per_mm, "1/mm")
      .done_as_result();
  using F = FrameQuality;
  StructClass<F>(core, "FrameQuality", "What one frame of a morph is, in numbers.\n")
      .result("components", &F::components, "pieces of a figure; connected surfaces of a mesh")
      .result("holes", &F::holes, "of a figure; of a mesh the genus of all its surfaces together")
      .result("content", &F::content, "area of a figure, mm²; volume of a body, mm³")
      .result("boundary", &F::boundary, "length of the outline, mm; area of the surface, mm²")
      .result("lowest_curvature", &F::lowest_curvature, "1/mm, positive where convex")
      .result("highest_curvature", &F::highest_curvature, "1/mm, positive where convex")
      .done_as_result();
  using O = Overlap;
  StructClass<O>(core, "Overlap", "How two label volumes on one grid agree about the voxels that are not 0.\n")
      .result("dice", &O::dice, "2|A∩B| / (|A|+|B|)")
      .result("volume_a_mm3", &O::volume_a_mm3, "mm³")
      .result("volume_b_mm3", &O::volume_b_mm3, "mm³")
      .done_as_result();
}

void bind_measures(py::module_& core) {
  core.def("measure_mesh", py::overload_cast<const TriangleMesh&>(&measure), py::arg("mesh"), unlocked);
  core.def(
      "measure_labels", [](const LabelVolume& labels) { return measured(labels, "labels").measures; },
      py::arg("labels"), unlocked);
  core.def(
      "measure_contours", [](const ContourSlice& slice, double scale_mm) { return measure(slice.contours, scale_mm); },
      py::arg("slice"), py::arg("scale_mm") = 1.0, unlocked);
  core.def("measure_quality", &measure_quality, py::arg("mesh"), unlocked, "How even the mesh's triangles are.");
  core.def(
      "frame_quality", [](const Shape& shape) { return frame_quality(shape); }, py::arg("shape"), unlocked,
      "What a frame of a morph is, in numbers.");
  core.def(
      "mean_curvatures_per_mm",
      [](const TriangleMesh& mesh) {
        const std::vector<double> values = mean_curvatures_per_mm(mesh);
        return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
      },
      py::arg("mesh"), "Mean curvature at every vertex, (N,) float64, 1/mm, positive where the body is convex.");
}

}  // namespace

void bind_metrics(py::module_& core) {
  bind_results(core);
  bind_measures(core);
  core.def(
      "compare",
      [](const std::variant<TriangleMesh, LabelVolume>& a, const std::variant<TriangleMesh, LabelVolume>& b,
         std::size_t samples, std::uint64_t seed) {
        const auto body = [](const std::variant<TriangleMesh, LabelVolume>& any) {
          return std::holds_alternative<TriangleMesh>(any) ? measured(std::get<TriangleMesh>(any))
                                                           : measured(std::get<LabelVolume>(any), "labels");
        };
        return compare(body(a), body(b), {.samples = samples, .seed = seed});
      },
      py::arg("first"), py::arg("second"), py::arg("samples"), py::arg("seed"), unlocked);
  core.def("overlap", &overlap, py::arg("a"), py::arg("b"), unlocked,
           "How two label volumes on one grid agree about the voxels that are not 0.");
  core.def("agreement_at_inputs", &agreement_at_inputs, py::arg("surface"), py::arg("contours"), unlocked,
           "Cuts of a closed surface by every input plane against the contours given there, both ways.");
  core.def(
      "plane_section",
      [](const TriangleMesh& mesh, const SlicePose& pose) {
        return ContourSlice{.name = mesh.name, .pose = pose, .contours = plane_section(mesh, pose)};
      },
      py::arg("mesh"), py::arg("pose"), unlocked,
      "Where the plane of a pose cuts a closed mesh: a ContourSlice, slice mm.");
  core.def("voxel_surface", &voxel_surface, py::arg("labels"), unlocked,
           "The faces between voxels that are not 0 and those that are, as a closed mesh, world LPS mm.");
  core.def(
      "voxelize",
      [](const TriangleMesh& mesh, LabelVolume& labels, std::uint16_t label) { voxelize(mesh, label, labels); },
      py::arg("mesh"), py::arg("labels"), py::arg("label") = 1, unlocked,
      "Sets the voxels of `labels` whose centre lies inside the closed mesh to `label`; others keep their value.");
}

}  // namespace isostack::python
