#include "python/bindings.h"
#include "python/progress.h"
#include "python/struct_class.h"
#include "recon/constraints/align.h"
#include "recon/constraints/crossings.h"
#include "recon/constraints/soften.h"

namespace isostack::python {

namespace {

void bind_contradictions(py::module_& core) {
  StructClass<Contradiction>(
      core, "Contradiction",
      "A stretch of the line two planes share on which one slice says inside, the other outside.\n")
      .result("length_mm", &Contradiction::length_mm, "along the line, mm")
      .result("distance_mm", &Contradiction::distance_mm, "how far apart the two contours are, mm")
      .done_as_result()
      .def_property_readonly(
          "ends_mm", [](const Contradiction& self) { return std::pair(self.ends[0].point_mm, self.ends[1].point_mm); },
          "both ends, world LPS mm")
      .def_property_readonly("middle_mm", &Contradiction::middle_mm, "world LPS mm");
  StructClass<SlicePair>(core, "SlicePair", "Two slices whose planes cross where at least one of them has the organ.\n")
      .result("first", &SlicePair::first, "index into the stack")
      .result("second", &SlicePair::second, "index into the stack")
      .result("first_name", &SlicePair::first_name, "of the slice")
      .result("second_name", &SlicePair::second_name, "of the slice")
      .result("line_mm", &SlicePair::line_mm, "length of the line within both fields of view, mm")
      .result("disagreement_mm", &SlicePair::disagreement_mm, "of that, where the two disagree, mm")
      .result("largest_mismatch_mm", &SlicePair::largest_mismatch_mm, "longest stretch, mm")
      .result("places", &SlicePair::places, "the stretches, in order along the line")
      .done_as_result();
  StructClass<Contradictions>(core, "Contradictions", "How the slices of one organ contradict each other.\n")
      .result("pairs", &Contradictions::pairs, "also those that agree, ordered by index")
      .done_as_result()
      .def_property_readonly("disagreement_mm", &Contradictions::disagreement_mm, "of all pairs together, mm")
      .def_property_readonly("largest_mismatch_mm", &Contradictions::largest_mismatch_mm, "of any pair, mm");
  core.def(
      "find_contradictions", [](const ContourStack& stack) { return find_contradictions(stack); }, py::arg("contours"),
      py::call_guard<py::gil_scoped_release>(),
      "Compares every pair of slices along the line their planes share, within both fields of view.");
}

void bind_alignment(py::module_& core) {
  using O = AlignOptions;
  StructClass<O>(core, "AlignOptions", "How far slices may be moved in their planes.\n")
      .field("rotation", &O::rotation, "also turn slices in their planes")
      .field("max_shift_mm", &O::max_shift_mm, "no slice moves farther, mm")
      .field("max_rotation_deg", &O::max_rotation_deg, "nor turns farther, degrees")
      .field("robust_pixels", &O::robust_pixels, "mismatches beyond count linearly, not squared")
      .field("stay", &O::stay, "weight of staying in place, against 1 for every crossing")
      .field("iterations", &O::iterations, "at most")
      .done();
  StructClass<InPlaneMotion>(core, "InPlaneMotion", "A turn about the middle of a slice's contours, then a shift.\n")
      .result("shift_mm", &InPlaneMotion::shift_mm, "along the slice's axes before the motion, mm")
      .result("rotation_rad", &InPlaneMotion::rotation_rad, "from x_axis towards y_axis, radians")
      .done_as_result();
  StructClass<Alignment>(core, "Alignment", "Slices moved in their planes.\n")
      .result("stack", &Alignment::stack, "the slices with their poses moved")
      .result("motions", &Alignment::motions, "one per slice")
      .result("iterations", &Alignment::iterations, "that were needed")
      .result("before", &Alignment::before, "contradictions before")
      .result("after", &Alignment::after, "contradictions after")
      .done_as_result();
  core.def(
      "align_slices",
      [](const ContourStack& contours, const AlignOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return align_slices(contours, options, p); });
      },
      py::arg("contours"), py::arg("options") = AlignOptions(), py::arg("progress") = py::none());
}

}  // namespace

void bind_crossings(py::module_& core) {
  bind_contradictions(core);
  bind_alignment(core);
  using S = SofteningOptions;
  StructClass<S>(core, "SofteningOptions", "Smoothing where crossing slices contradict each other.\n")
      .field("least_pixels", &S::least_pixels, "contradictions nearer than this are met exactly, pixels")
      .field("strength", &S::strength, "factor on the smoothing; 0 softens nothing")
      .field("reach", &S::reach, "radius round a contradiction, as a multiple of how far apart its contours are")
      .done();
}

}  // namespace isostack::python
