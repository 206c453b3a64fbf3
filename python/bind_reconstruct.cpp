#include "python/arrays.h"
#include "python/bindings.h"
#include "python/progress.h"
#include "python/struct_class.h"
#include "recon/reconstruct.h"
#include "recon/reconstruct_all.h"

namespace isostack::python {

namespace {

void bind_report(py::module_& core) {
  StructClass<SolveStage>(core, "SolveStage", "A stage of a solve.\n")
      .result("name", &SolveStage::name, "of the stage")
      .result("seconds", &SolveStage::seconds, "s")
      .result("bytes", &SolveStage::bytes, "held by the stage's result")
      .done_as_result();
  using R = ReconstructReport;
  StructClass<R>(core, "ReconstructReport", "What was done.\n")
      .result("contour_points", &R::contour_points, "on all contours")
      .result("boundary_constraints", &R::boundary_constraints, "of those, kept")
      .result("constraints", &R::constraints, "solved for, at different points")
      .result("merged_constraints", &R::merged_constraints, "left out because they coincide with another")
      .result("largest_contradiction", &R::largest_contradiction, "largest difference of values averaged by that")
      .result("contradictions", &R::contradictions, "between crossing slices, as they were given")
      .result("softened_constraints", &R::softened_constraints, "given smoothing because of them")
      .result("predicted_bytes", &R::predicted_bytes, "of the solver, known before it starts")
      .result("solves", &R::solves, "solves")
      .result("solver", &R::solver, "\"dense\" or \"fast\"")
      .result("iterations", &R::iterations, "of the fast solver, all solves together")
      .result("sweeps", &R::sweeps, "of the fast solver, all solves together")
      .result("tolerance", &R::tolerance, "residual asked for, mm")
      .result("largest_residual", &R::largest_residual, "of the system after the last solve, mm")
      .result("converged", &R::converged, "the last solve met the tolerance")
      .result("residual_remark", &R::residual_remark, "where and why, when it did not")
      .result("solve_stages", &R::solve_stages, "seconds of all solves together, largest bytes")
      .result("resolution_mm", &R::resolution_mm, "cell size of the surface, mm")
      .result("contour_points_without_surface", &R::contour_points_without_surface, "points")
      .result("plane_points", &R::plane_points, "lattice points compared with the segmentation, all planes together")
      .result("plane_points_wrong", &R::plane_points_wrong, "of those, more than a pixel on the wrong side")
      .result("between_points_wrong", &R::between_points_wrong, "between slices")
      .result("plane_constraints", &R::plane_constraints, "constraints added for them")
      .result("section_constraints", &R::section_constraints, "added because sections strayed")
      .result("contour_residual", &R::contour_residual, "of all contour points, whether constraints or not")
      .result("sections", &R::sections, "cuts of the surface by all input planes against the contours there")
      .result("smoothing", &R::smoothing, "ρ that met the tolerance, or that was given")
      .result("retriangulation", &R::retriangulation, "when it was asked for, or None")
      .result("shares_faces_with", &R::shares_faces_with, "organs that had to be kept from overlapping this one")
      .result("open_end", &R::open_end, "the organ is cut by the end of the stack: the surface is flat there")
      .result("cut_by_bounds", &R::cut_by_bounds, "flat there, or cut at the box round the contours")
      .result("constraint_seconds", &R::constraint_seconds, "s")
      .result("solve_seconds", &R::solve_seconds, "s")
      .result("surface_seconds", &R::surface_seconds, "s")
      .result("peak_bytes", &R::peak_bytes, "of the whole process")
      .done_as_result();
}

}  // namespace

void bind_reconstruct(py::module_& core) {
  bind_report(core);
  py::class_<Reconstruction> result(core, "Reconstruction", "A surface and how it came about.");
  result.def_readonly("surface", &Reconstruction::surface, "the TriangleMesh, world LPS mm");
  result.def_property_readonly(
      "kept_points_mm",
      [](const py::object& self) { return rows_view(self.cast<Reconstruction&>().kept_points_mm, self); },
      "(N, 3) float64, world LPS mm, a view: the contour points that became boundary constraints");
  result.def_readonly("report", &Reconstruction::report, "what was done");
  core.def(
      "reconstruct",
      [](const ContourStack& contours, const ReconstructOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return reconstruct(contours, options, p); });
      },
      py::arg("contours"), py::arg("options") = ReconstructOptions(), py::arg("progress") = py::none());
  core.def(
      "reconstruct_all",
      [](const std::vector<ContourStack>& organs, const ReconstructOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return reconstruct_all(organs, options, p); });
      },
      py::arg("organs"), py::arg("options") = ReconstructOptions(), py::arg("progress") = py::none());
  core.def(
      "reconstruct_turk_obrien",
      [](const SliceStack& images, double level, const ReconstructOptions& options, const py::object& progress) {
        return without_lock(progress,
                            [&](const Progress& p) { return reconstruct_turk_obrien(images, level, options, p); });
      },
      py::arg("images"), py::arg("level"), py::arg("options") = ReconstructOptions(), py::arg("progress") = py::none());
  core.def(
      "retriangulate",
      [](const TriangleMesh& mesh, const RetriangulationOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) {
          RetriangulationReport report;
          TriangleMesh surface = retriangulate(mesh, options, report, nullptr, p);
          return std::pair(std::move(surface), report);
        });
      },
      py::arg("mesh"), py::arg("options"), py::arg("progress") = py::none());
}

}  // namespace isostack::python
