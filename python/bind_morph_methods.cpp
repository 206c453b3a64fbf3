#include "python/bindings.h"
#include "python/progress.h"
#include "python/struct_class.h"
#include "recon/morphing/blend_morph.h"
#include "recon/morphing/signed_distance_morph.h"
#include "recon/morphing/variational_morph.h"

namespace isostack::python {

namespace {

void bind_variational(py::module_& core) {
  py::enum_<MorphRecipe>(core, "MorphRecipe", "What constraints a shape gives.")
      .value("signed_distance", MorphRecipe::signed_distance, "0 on the boundary, distances in mm beside it")
      .value("turk_obrien", MorphRecipe::turk_obrien, "the paper's: 0 on the boundary and 1 a little inside");
  using V = VariationalMorphOptions;
  StructClass<V>(core, "VariationalMorphOptions", "Turk & O'Brien 1999: one function through all key shapes.\n")
      .field("recipe", &V::recipe, "\"signed_distance\" or \"turk_obrien\"")
      .field("kernel", &V::kernel, "\"triharmonic\", \"biharmonic\" or \"thin_plate\"")
      .field("layout", &V::layout, "\"line\", \"simplex\" or \"given\"")
      .field("spacing_mm", &V::spacing_mm, "mean distance of neighbouring key shapes, mm; None: by the shapes' size")
      .field("offset_pixels", &V::offset_pixels, "figures: distance of the partners")
      .field("offset_fraction", &V::offset_fraction, "bodies: the same, in longest sides of the shape's box")
      .field("sample_spacing_pixels", &V::sample_spacing_pixels, "figures: nearer boundary points are left out")
      .field("max_constraints", &V::max_constraints, "of all key shapes together")
      .field("smoothing", &V::smoothing, "ρ of every constraint; 0 interpolates")
      .field("solver", &V::solver, "\"automatic\", \"dense\" or \"fast\"")
      .field("solve_tolerance_pixels", &V::solve_tolerance_pixels, "largest residual of the fast solver")
      .field("resolution_mm", &V::resolution_mm, "of the frames, mm; 0: a pixel, or a hundredth of the longest side")
      .field("memory_limit_bytes", &V::memory_limit_bytes, "that the solve may take")
      .done();
  core.def(
      "variational_morph",
      [](const std::vector<KeyShape>& shapes, const VariationalMorphOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return variational_morph(shapes, options, p); });
      },
      py::arg("shapes"), py::arg("options") = VariationalMorphOptions(), py::arg("progress") = py::none());
}

void bind_signed_distance(py::module_& core) {
  py::enum_<AlongNormal>(core, "AlongNormal", "How values go from shape to shape.")
      .value("linear", AlongNormal::linear, "between the two next to the place")
      .value("cubic", AlongNormal::cubic, "natural cubic spline through all");
  using S = SignedDistanceMorphOptions;
  StructClass<S>(core, "SignedDistanceMorphOptions", "The baseline: weighted means of signed distances.\n")
      .field("layout", &S::layout, "\"line\", \"simplex\" or \"given\"")
      .field("between", &S::between, "\"linear\" or \"cubic\"")
      .field("resolution_mm", &S::resolution_mm, "of the frames, mm; 0: a pixel, or a hundredth of the longest side")
      .field("memory_limit_bytes", &S::memory_limit_bytes, "of the distance grids of bodies")
      .done();
  core.def(
      "signed_distance_morph",
      [](const std::vector<KeyShape>& shapes, const SignedDistanceMorphOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return signed_distance_morph(shapes, options, p); });
      },
      py::arg("shapes"), py::arg("options") = SignedDistanceMorphOptions(), py::arg("progress") = py::none());
}

void bind_blend_parts(py::module_& core) {
  StructClass<TimeSpan>(core, "TimeSpan", "From one time to another.\n")
      .field("from_", &TimeSpan::from, "shares of the way from one key shape to the next")
      .field("to", &TimeSpan::to, "shares of the way")
      .done();
  using B = BlendParameters;
  StructClass<B>(core, "BlendParameters", "Of one bounded blend (Pasko et al. 2004, equations 1 to 3).\n")
      .field("a0", &B::a0, "displacement where both boundaries meet, mm, ≥ 0")
      .field("a1", &B::a1, "how far from the first solid the displacement reaches, > 0")
      .field("a2", &B::a2, "how far from the second, > 0")
      .field("a3", &B::a3, "the smaller, the farther it keeps its strength inside the bounds, > 0")
      .done();
  py::enum_<HalfCylinderEnds>(core, "HalfCylinderEnds", "Where a shape's half-cylinder ends.")
      .value("smoothed", HalfCylinderEnds::smoothed, "it tapers off")
      .value("flat", HalfCylinderEnds::flat, "cut by a plane");
  using D = KeyDeformation;
  StructClass<D>(core, "KeyDeformation", "A point of a key shape moves on its way to the next.\n")
      .field("key", &D::key, "the shape that is left")
      .field("from_mm", &D::from_mm, "slice mm in the first figure's pose, or world mm")
      .field("to_mm", &D::to_mm, "the same")
      .field("radius_mm", &D::radius_mm, "surroundings it takes along, mm; 0: two ways")
      .field("during", &D::during, "in shares of the way between the two shapes")
      .done();
}

void bind_blend(py::module_& core) {
  bind_blend_parts(core);
  using O = BlendMorphOptions;
  StructClass<O>(core, "BlendMorphOptions", "Bounded space-time blending (Pasko, Pasko & Kunii 2004).\n")
      .field("ends", &O::ends, "\"smoothed\" or \"flat\"")
      .field("slab", &O::slab, "the blend's bounds, in shares of the way from one key shape to the next")
      .field("gap", &O::gap, "between the half-cylinders; None: a 41st of the slab, in its middle")
      .field("length_mm", &O::length_mm, "from one key shape to the next; None: the slab is 2.05 longest sides")
      .field("blend", &O::blend, "None: a1 = a2 = 2, a3 = 1, and a0 as least_content tells")
      .field("smoothing", &O::smoothing, "None: a0 is the shape's inradius, a1 = a2 = 0.7, a3 = 1")
      .field("smoothing_reach_mm", &O::smoothing_reach_mm, "None: up to the slab's end")
      .field("least_content", &O::least_content, "no frame has less than this share of the smaller shape's content")
      .field("deformations", &O::deformations, "points that move on their way")
      .field("resolution_mm", &O::resolution_mm, "of the frames, mm; 0: a pixel, or a hundredth of the longest side")
      .done();
  core.def(
      "blend_morph",
      [](const std::vector<KeyShape>& shapes, const BlendMorphOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return blend_morph(shapes, options, p); });
      },
      py::arg("shapes"), py::arg("options") = BlendMorphOptions(), py::arg("progress") = py::none());
}

}  // namespace

void bind_morph_methods(py::module_& core) {
  bind_variational(core);
  bind_signed_distance(core);
  bind_blend(core);
}

}  // namespace isostack::python
