#include "python/bindings.h"
#include "python/progress.h"
#include "python/struct_class.h"
#include "recon/morphing/subdivision_morph.h"

namespace isostack::python {

namespace {

void bind_features(py::module_& core) {
  StructClass<FeaturePoint>(core, "FeaturePoint",
                            "A point of a key shape: one of its vertices, or the nearest to a place.\n")
      .field("shape", &FeaturePoint::shape, "which key shape")
      .field("vertex", &FeaturePoint::vertex, "of all its contours' points, counted through, or of the mesh's; or None")
      .field("place_mm", &FeaturePoint::place_mm, "without a vertex: slice mm in the first figure's pose, or world mm")
      .done();
  StructClass<TimedPlace>(core, "TimedPlace", "Where something is at a time.\n")
      .field("t", &TimedPlace::t, "share of the way from the first key shape to the last")
      .field("place_mm", &TimedPlace::place_mm, "slice mm in the first figure's pose, or world mm")
      .done();
  using C = CorrespondingPoints;
  StructClass<C>(core, "CorrespondingPoints", "Two points of neighbouring key shapes become one another.\n")
      .field("from_", &C::from, "the first")
      .field("to", &C::to, "the second")
      .field("by_way_of", &C::by_way_of, "a curve through these; none: straight")
      .field("sharp", &C::sharp, "a corner there stays one all the way")
      .done();
  using E = EnhancedTransition;
  StructClass<E>(core, "EnhancedTransition",
                 "The vertex of a level nearest to a time and a place is pulled elsewhere.\n")
      .field("level", &E::level, "coarse levels pull broadly")
      .field("at", &E::at, "which vertex")
      .field("to_mm", &E::to_mm, "where it goes")
      .done();
}

void bind_parts(py::module_& core) {
  py::class_<TopologicalKeyShape> key(core, "TopologicalKeyShape",
                                      "How parts join and split between two key shapes: curves that touch at points.");
  key.def(py::init([](const Shape& shape, double t, std::string name) {
            return TopologicalKeyShape{std::move(name), shape, t};
          }),
          py::arg("shape"), py::arg("t") = 0.5, py::arg("name") = "topological key shape");
  key.def_readonly("t", &TopologicalKeyShape::t, "share of the way from the first key shape to the last");
  py::enum_<DetailsBetween>(core, "DetailsBetween", "What becomes of details of the key shapes.")
      .value("fade", DetailsBetween::fade, "smoothed away, the finer the faster")
      .value("linger", DetailsBetween::linger, "added to the smooth blend, in proportion to the way left");
  StructClass<TimeWarp>(core, "TimeWarp", "A blend that goes on at different times at different places.\n")
      .field("controls", &TimeWarp::controls, "2 × 16 (figures) or 2 × 64 (bodies): times at 1/3 and 2/3")
      .done();
  core.def("sweep", &sweep, py::arg("direction"), py::arg("lag"),
           "A warp by which what lies first along the direction changes first; the lag is below 1.");
}

}  // namespace

void bind_subdivision_morph(py::module_& core) {
  bind_features(core);
  bind_parts(core);
  using O = SubdivisionMorphOptions;
  StructClass<O>(core, "SubdivisionMorphOptions", "Blending by subdivision surfaces (Ohbuchi et al. 2001).\n")
      .field("levels", &O::levels, "the base is subdivided so many times, at least 1")
      .field("gamma", &O::gamma, "weights of the levels")
      .field("smoothing_passes", &O::smoothing_passes, "at each level; 0 smooths nothing")
      .field("details", &O::details, "\"fade\" or \"linger\"")
      .field("sharp_angle_rad", &O::sharp_angle_rad, "figures: vertices turning less are rounded; bodies: edges kept")
      .field("spacing_mm", &O::spacing_mm, "between neighbouring key shapes, mm; None: half the box's longest side")
      .field("tolerance_share", &O::tolerance_share, "figures: how far the base may be off, in diagonals of the box")
      .field("features", &O::features, "points that become one another")
      .field("transitions", &O::transitions, "vertices that are pulled")
      .field("key_shapes", &O::key_shapes, "topological key shapes")
      .field("warp", &O::warp, "times that differ from place to place")
      .done();
  core.def(
      "subdivision_morph",
      [](const std::vector<KeyShape>& shapes, const SubdivisionMorphOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return subdivision_morph(shapes, options, p); });
      },
      py::arg("shapes"), py::arg("options") = SubdivisionMorphOptions(), py::arg("progress") = py::none());
}

}  // namespace isostack::python
