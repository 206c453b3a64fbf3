#include "python/bindings.h"
#include "python/struct_class.h"
#include "recon/reconstruct.h"

namespace isostack::python {

namespace {

void bind_kernel(py::module_& core) {
  py::class_<Kernel> kernel(core, "Kernel",
                            "A radial kernel: \"biharmonic\" r, \"thin_plate\" r² log r, \"triharmonic\" r³.");
  kernel.def(py::init(&kernel_named), py::arg("name"));
  kernel.def_property_readonly("name", &Kernel::name, "one of the three names, or Duchon's");
  kernel.def(
      "__eq__",
      [](const Kernel& a, const Kernel& b) {
        return a.power == b.power && a.logarithmic == b.logarithmic && a.tail_degree == b.tail_degree;
      },
      py::arg("other"));
  kernel.def("__repr__", [](const Kernel& self) { return "Kernel('" + self.name() + "')"; });
}

}  // namespace

void bind_reconstruct_options(py::module_& core) {
  bind_kernel(core);
  py::enum_<SolverChoice>(core, "SolverChoice", "How a system is solved.")
      .value("automatic", SolverChoice::automatic, "whichever takes less time")
      .value("dense", SolverChoice::dense, "directly: the reference")
      .value("fast", SolverChoice::fast, "for very many constraints");
  py::enum_<Caps>(core, "Caps", "How a surface ends beyond the outermost slices of a parallel stack.")
      .value("round", Caps::round, "it closes by itself")
      .value("flat", Caps::flat, "half a gap outside the outermost slices with contours")
      .value("open", Caps::open, "at the outermost slices with contours, without a lid");
  using R = ReconstructOptions;
  StructClass<R>(core, "ReconstructOptions", "How a surface is made of contours. Pixels: the smaller spacing.\n")
      .field("kernel", &R::kernel, "\"triharmonic\" (r³), \"biharmonic\" (r) or \"thin_plate\" (r² log r)")
      .field("smoothing", &R::smoothing, "ρ of every constraint; 0 interpolates")
      .field("softening", &R::softening, "smoothing where crossing slices contradict each other")
      .field("tolerance_mm", &R::tolerance_mm,
             "the smoothest surface within this distance of all contour points, mm; None: `smoothing` as it is")
      .field("thin_mm", &R::thin_mm,
             "as few constraints as bring all contour points within this distance, mm; 0: as many as are allowed")
      .field("offset_pixels", &R::offset_pixels, "distance of the partners inside and outside the contour")
      .field("solves", &R::solves, "solves that settle the oblique cuts; 1 leaves them uncorrected")
      .field("plane_check_rounds", &R::plane_check_rounds, "repairs at most, after comparing f with every plane")
      .field("section_tolerance_pixels", &R::section_tolerance_pixels,
             "sections farther than this from the contours are repaired")
      .field("section_rounds", &R::section_rounds, "of such repairs at most")
      .field("sample_spacing_pixels", &R::sample_spacing_pixels, "nearer contour points are left out")
      .field("solver", &R::solver, "\"automatic\", \"dense\" or \"fast\"")
      .field("solve_tolerance_pixels", &R::solve_tolerance_pixels, "largest residual of the fast solver")
      .field("accept_residual", &R::accept_residual, "go on with the best solution when the solve stalls")
      .field("accept_lost_contours", &R::accept_lost_contours, "go on when the surface misses a contour")
      .field("max_constraints", &R::max_constraints, "contours are thinned to this many")
      .field("resolution_mm", &R::resolution_mm, "cell size of the surface, mm; 0: a pixel, half of it for thin parts")
      .field("caps", &R::caps, "\"round\", \"flat\" or \"open\": ends beyond a parallel stack")
      .field("retriangulation", &R::retriangulation, "of the extracted surface")
      .field("allow_overlap", &R::allow_overlap, "reconstruct_all: leave each surface as it is by itself")
      .field("memory_limit_bytes", &R::memory_limit_bytes, "that the solve may take")
      .done();
  core.def("interpolating", &interpolating, py::arg("options") = ReconstructOptions(),
           "The same options, but passing through every constraint, also contradicting ones, as --interpolate.");
}

}  // namespace isostack::python
