#include "python/bindings.h"
#include "python/progress.h"
#include "python/struct_class.h"
#include "recon/geometry/peak_memory.h"
#include "recon/metrics/choose_kernel.h"
#include "recon/metrics/leave_out.h"
#include "recon/predicted_memory.h"

namespace isostack::python {

namespace {

void bind_prediction(py::module_& core) {
  using O = OrganPrediction;
  StructClass<O>(core, "OrganPrediction", "What one organ's reconstruction takes; upper estimates.\n")
      .result("name", &O::name, "of the organ")
      .result("constraints", &O::constraints, "of the first solve")
      .result("most_constraints", &O::most_constraints, "after what planes and sections may add")
      .result("resolution_mm", &O::resolution_mm, "of the extraction, mm")
      .result("cells", &O::cells, "of the extraction that the surface passes")
      .result("solver", &O::solver, "\"dense\" or \"fast\"")
      .result("solver_bytes", &O::solver_bytes, "of the first solve, which the memory limit is compared with")
      .result("solve_bytes", &O::solve_bytes, "at most while solving and evaluating")
      .result("surface_bytes", &O::surface_bytes, "at most while the surface is extracted")
      .done_as_result();
  StructClass<MemoryPrediction>(core, "MemoryPrediction", "What a reconstruction takes, known before it starts.\n")
      .result("organs", &MemoryPrediction::organs, "one by one")
      .result("process_bytes", &MemoryPrediction::process_bytes, "the most that the process will hold at any time")
      .done_as_result();
  core.def(
      "predict_memory",
      [](const std::vector<ContourStack>& organs, const ReconstructOptions& options) {
        return predict_memory(organs, options, resident_memory_bytes());
      },
      py::arg("organs"), py::arg("options") = ReconstructOptions(), py::call_guard<py::gil_scoped_release>());
}

}  // namespace

void bind_studies(py::module_& core) {
  bind_prediction(core);
  StructClass<KernelTrial>(core, "KernelTrial",
                           "A kernel and a smoothing, and how well they predict slices left out.\n")
      .result("kernel", &KernelTrial::kernel, "the kernel")
      .result("smoothing", &KernelTrial::smoothing, "ρ of every constraint")
      .result("agreement", &KernelTrial::agreement, "on the slices left out")
      .done_as_result();
  StructClass<MethodAgreement>(core, "MethodAgreement",
                               "One method's contours on the dropped slices against their own.\n")
      .result("method", &MethodAgreement::method, "\"isostack\", \"cubic\" or \"linear\"")
      .result("agreement", &MethodAgreement::agreement, "on the dropped slices")
      .result("seconds", &MethodAgreement::seconds, "s")
      .done_as_result();
  using S = LeaveOutStudy;
  StructClass<S>(core, "LeaveOutStudy", "How well slices nobody was shown come back.\n")
      .result("every", &S::every, "every so many slices one was kept")
      .result("kept", &S::kept, "slices")
      .result("dropped", &S::dropped, "slices compared")
      .result("methods", &S::methods, "isostack, and for parallel slices two baselines")
      .result("report", &S::report, "of the reconstruction from the kept slices")
      .done_as_result();
  core.def(
      "try_kernels",
      [](const ContourStack& contours, const ReconstructOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return try_kernels(contours, options, p); });
      },
      py::arg("contours"), py::arg("options") = ReconstructOptions(), py::arg("progress") = py::none());
  core.def(
      "leave_out",
      [](const ContourStack& contours, int every, const ReconstructOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return leave_out(contours, every, options, p); });
      },
      py::arg("contours"), py::arg("every"), py::arg("options") = ReconstructOptions(),
      py::arg("progress") = py::none());
}

}  // namespace isostack::python
