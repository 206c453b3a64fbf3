#include "python/bindings.h"
#include "python/progress.h"
#include "python/struct_class.h"
#include "recon/morphing/level_set_morph.h"

namespace isostack::python {

namespace {

void bind_choices(py::module_& core) {
  py::enum_<ApproachProfile>(core, "ApproachProfile", "The speed as a function of the signed distance to the target.")
      .value("identity", ApproachProfile::identity, "the distance")
      .value("clamped", ApproachProfile::clamped, "the distance within ± the width")
      .value("tanh", ApproachProfile::tanh, "width · tanh(distance / width)");
  py::enum_<FramePacing>(core, "FramePacing", "What goes evenly along the sequence.")
      .value("time", FramePacing::time, "the evolution's own")
      .value("volume_fraction", FramePacing::volume_fraction, "the share of what lay in one of the shapes only")
      .value("rms_distance", FramePacing::rms_distance, "root mean square distance to the target");
  py::enum_<TransformKind>(core, "TransformKind", "A map of one key shape to the next.")
      .value("none", TransformKind::none, "none")
      .value("rigid", TransformKind::rigid, "turn and shift")
      .value("affine", TransformKind::affine, "turn, stretch, shear and shift")
      .value("warp", TransformKind::warp, "through all landmarks");
  py::enum_<UnsharedParts>(core, "UnsharedParts", "What becomes of parts where the shape before has nothing.")
      .value("leave", UnsharedParts::leave, "they stay missing")
      .value("seed", UnsharedParts::seed, "a ball is put into each, and grows from there");
}

void bind_courses(py::module_& core) {
  using U = UnsharedPart;
  StructClass<U>(core, "UnsharedPart", "A part of one key shape that the one before does not overlap, or a hollow.\n")
      .result("from_", &U::from, "name of the shape before")
      .result("to", &U::to, "name of the shape")
      .result("is_hollow", &U::is_hollow, "a hollow that the shape before fills")
      .result("place_mm", &U::place_mm, "its innermost point, world LPS mm")
      .result("content", &U::content, "mm² or mm³")
      .done_as_result();
  using S = LevelSetStep;
  StructClass<S>(core, "LevelSetStep", "Where an evolution is after a step.\n")
      .result("time", &S::time, "the evolution's own")
      .result("shared_fraction", &S::shared_fraction, "of the target's area or volume")
      .result("matched_fraction", &S::matched_fraction, "of what lay in one of the two shapes only")
      .result("rms_mm", &S::rms_mm, "RMS distance of the boundary to the target's, mm")
      .result("largest_mm", &S::largest_mm, "the largest such distance, mm")
      .done_as_result();
  using C = LevelSetCourse;
  StructClass<C>(core, "LevelSetCourse", "An evolution from one key shape to the next.\n")
      .result("from_", &C::from, "name of the first")
      .result("to", &C::to, "name of the second")
      .result("steps", &C::steps, "the first is before any step")
      .result("arrived", &C::arrived, "False: it stopped at the limit of steps, or moved no more")
      .done_as_result();
}

}  // namespace

void bind_level_set_morph(py::module_& core) {
  bind_choices(core);
  bind_courses(core);
  using O = LevelSetMorphOptions;
  StructClass<O>(core, "LevelSetMorphOptions", "Breen & Whitaker 2001. Pixels: the resolution.\n")
      .field("profile", &O::profile, "\"identity\", \"clamped\" or \"tanh\"")
      .field("width_pixels", &O::width_pixels, "of the profiles clamped and tanh")
      .field("pacing", &O::pacing, "\"time\", \"volume_fraction\" or \"rms_distance\"")
      .field("transform", &O::transform, "\"none\", \"rigid\", \"affine\" or \"warp\"")
      .field("landmarks", &O::landmarks, "LandmarkPair of two key shapes")
      .field("unshared", &O::unshared, "\"leave\" or \"seed\"")
      .field("stop_rms_pixels", &O::stop_rms_pixels, "an evolution ends when the RMS distance is below this")
      .field("max_steps", &O::max_steps, "of an evolution, at most")
      .field("resolution_mm", &O::resolution_mm, "of the nodes, mm; 0: a pixel, or a hundredth of the longest side")
      .field("memory_limit_bytes", &O::memory_limit_bytes, "of the nodes")
      .done();
  core.def(
      "level_set_morph",
      [](const std::vector<KeyShape>& shapes, const LevelSetMorphOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) {
          LevelSetPlan plan = plan_level_set_morph(shapes, options, p);
          std::vector<UnsharedPart> unshared = plan.unshared;
          LevelSetMorph made = run_level_set_morph(std::move(plan), p);
          return std::tuple(std::move(made.morph), std::move(made.courses), std::move(unshared));
        });
      },
      py::arg("shapes"), py::arg("options") = LevelSetMorphOptions(), py::arg("progress") = py::none());
}

}  // namespace isostack::python
