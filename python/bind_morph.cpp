#include <pybind11/functional.h>

#include "python/arrays.h"
#include "python/bindings.h"
#include "python/progress.h"
#include "python/struct_class.h"
#include "recon/geometry/errors.h"
#include "recon/morphing/morph.h"
#include "recon/morphing/spacetime_surface.h"
#include "recon/morphing/warp.h"

namespace isostack::python {

namespace {

GreyFigure grey_figure(const py::object& pixels, double level) {
  const py::array array = checked_array(pixels, py::dtype::of<float>(), 2, "pixels");
  return {
      .pixels = Eigen::Map<const Image<float>>(static_cast<const float*>(array.data()), array.shape(0), array.shape(1)),
      .level = level};
}

void bind_key_shapes(py::module_& core) {
  py::class_<GreyFigure> figure(core, "GreyFigure", "The picture a figure was drawn in: at least `level` is inside.");
  figure.def(py::init(&grey_figure), py::arg("pixels"), py::arg("level"), "pixels: (rows, columns), copied.");
  figure.def_readonly("level", &GreyFigure::level, "grey value");
  py::class_<KeyShape> key(core, "KeyShape",
                           "A given shape, which the morph takes on at its place: a figure (ContourSlice) or a body "
                           "(TriangleMesh, closed, outside out).");
  key.def(
      py::init([](const Shape& shape, std::string name, std::optional<double> time, const Eigen::VectorXd& place,
                  const std::optional<GreyFigure>& image) {
        return KeyShape{std::move(name), shape, time, place, image};
      }),
      py::arg("shape"), py::arg("name") = "shape", py::arg("time") = py::none(), py::arg("place") = Eigen::VectorXd(),
      py::arg("image") = py::none(),
      "time: on a line, in any unit, ascending; None: evenly. place: with KeyLayout.given, in units of the spacing. "
      "image: of a figure, for the recipe turk_obrien.");
  key.def_readonly("name", &KeyShape::name, "names the shape in messages");
  key.def_readonly("shape", &KeyShape::shape, "a copy");
  key.def_readonly("time", &KeyShape::time, "on a line, or None");
  py::class_<LandmarkPair> pair(core, "LandmarkPair",
                                "Points of the first and the last shape that belong together; world LPS mm, of figures "
                                "in their plane.");
  pair.def(py::init([](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
             return LandmarkPair{from, to};
           }),
           py::arg("from_mm"), py::arg("to_mm"));
  pair.def_readonly("from_mm", &LandmarkPair::from_mm, "world LPS mm");
  pair.def_readonly("to_mm", &LandmarkPair::to_mm, "world LPS mm");
}

void bind_report(py::module_& core) {
  using S = SolveReport;
  StructClass<S>(core, "SolveReport", "What a solve reached.\n")
      .result("solver", &S::solver, "\"dense\" or \"fast\"; empty: nothing was solved")
      .result("tolerance", &S::tolerance, "residual asked for, mm")
      .result("largest_residual", &S::largest_residual, "reached, mm")
      .result("converged", &S::converged, "whether it met the tolerance")
      .result("iterations", &S::iterations, "of conjugate gradients")
      .result("sweeps", &S::sweeps, "between corrections")
      .result("remark", &S::remark, "where and why, when it did not converge")
      .result("predicted_bytes", &S::predicted_bytes, "before it started")
      .done_as_result();
  using R = MorphReport;
  StructClass<R>(core, "MorphReport", "What was done to make a morph.\n")
      .result("method", &R::method, "\"variational\", \"level-set\", ...")
      .result("spacing_mm", &R::spacing_mm, "mean distance of neighbouring key shapes in the extra dimensions, mm")
      .result("constraints", &R::constraints, "solved for, of all key shapes together")
      .result("solve", &R::solve, "empty when the method solves nothing")
      .result("constraint_seconds", &R::constraint_seconds, "s")
      .result("solve_seconds", &R::solve_seconds, "s")
      .result("resolution_mm", &R::resolution_mm, "of the frames, mm")
      .result("landmarks", &R::landmarks, "corresponding points that guided it")
      .done_as_result();
}

std::vector<Shape> frames_of(const Morph& morph, const std::variant<std::size_t, std::vector<Eigen::VectorXd>>& which,
                             const py::object& progress) {
  return without_lock(progress, [&](const Progress& p) {
    return std::visit([&](const auto& frames) { return morph.frames(frames, p); }, which);
  });
}

ContourStack slices_of(const Morph& morph, const std::vector<ContourSlice>& figures,
                       const std::vector<Eigen::VectorXd>& weights) {
  if (figures.empty() || figures.size() != weights.size())
    throw InputError(
        "spacetime_slices",
        std::to_string(figures.size()) + " figures and " + std::to_string(weights.size()) + " lists of weights",
        "give one list of weights for each figure, and one figure at least");
  return spacetime_slices(morph, figures, weights);
}

}  // namespace

void bind_morph(py::module_& core) {
  bind_key_shapes(core);
  bind_report(core);
  py::enum_<KeyLayout>(core, "KeyLayout", "How the key shapes lie in the extra dimensions.")
      .value("line", KeyLayout::line, "along t, one after the other")
      .value("simplex", KeyLayout::simplex, "each at a corner: any mixture of them has a place")
      .value("given", KeyLayout::given, "at KeyShape.place");
  py::class_<Morph> morph(core, "Morph",
                          "Shapes between given shapes, whatever the method. Figures come out as ContourSlice in the "
                          "first key shape's pose, bodies as closed TriangleMesh in world LPS mm.");
  morph.def(
      "shape_at",
      [](const Morph& self, double t, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return self.shape_at(t, p); });
      },
      py::arg("t"), py::arg("progress") = py::none(), "At t in [0, 1], from the first key shape to the last.");
  morph.def(
      "at",
      [](const Morph& self, const Eigen::VectorXd& weights, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return self.at(weights, p); });
      },
      py::arg("weights"), py::arg("progress") = py::none(),
      "At the place with these weights: one per key shape, none negative, sum 1.");
  morph.def(
      "frames", &frames_of, py::arg("count_or_weights"), py::arg("progress") = py::none(),
      "So many frames evenly in t, both ends included; or one for each list of weights. For less than one by one.");
  morph.def(
      "weights_at", [](const Morph& self, double t) { return self.places().weights_at(t); }, py::arg("t"),
      "The weights of the place at t.");
  morph.def_property_readonly(
      "report", [](const Morph& self) { return self.report(); }, "what was done");
  morph.def(
      "spacetime_surface",
      [](const Morph& self, const SlicePose& pose, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return spacetime_surface(self, pose, p); });
      },
      py::arg("pose"), py::arg("progress") = py::none(),
      "The surface that all figures sweep, t in mm along the normal of `pose`, the pose of a frame; world LPS mm, open "
      "at both ends. None: level-set morphs, bodies, and shapes that do not lie on a line have none.");
  morph.def(
      "spacetime_slices", &slices_of, py::arg("figures"), py::arg("weights"),
      "Frames as slices of one stack, each as far along the normal as it is in the extra dimensions: the sections "
      "of spacetime_surface(). One list of weights for each figure.");
  core.def("weights_along_path", &weights_along_path, py::arg("corners"), py::arg("count"),
           "`count` weights, evenly along straight lines from each corner of a path to the next.");
  core.def("warped_morph", &warped_morph, py::arg("shapes"), py::arg("landmarks"), py::arg("make_morph"));
}

}  // namespace isostack::python
