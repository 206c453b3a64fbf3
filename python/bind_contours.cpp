#include <numeric>

#include "python/arrays.h"
#include "python/bindings.h"
#include "python/sequences.h"
#include "recon/geometry/contour.h"

namespace isostack::python {

namespace {

py::array points_view(const py::object& self) { return rows_view(self.cast<Contour&>().points_mm, self); }

void bind_contour(py::module_& core) {
  py::class_<Contour> contour(core, "Contour",
                              "A closed planar curve in slice mm; the last point joins the first and is not repeated. "
                              "The organ lies to the left walking along: outer curves have positive area, holes "
                              "negative.");
  contour.def(py::init([](const py::object& points_mm, int depth) {
                return Contour{rows_from<double, 2>(points_mm, "points_mm"), depth};
              }),
              py::arg("points_mm"), py::arg("depth") = 0, "points_mm: (N, 2) real numbers, slice mm, copied.");
  contour.def_property(
      "points_mm", &points_view,
      [](const py::object& self, const py::object& values) { assign_in_place(points_view(self), values, "points_mm"); },
      "(N, 2) float64, slice mm, a view");
  contour.def_readwrite("depth", &Contour::depth, "nesting: 0 outer, 1 hole, 2 island within a hole");
  contour.def_property_readonly("signed_area_mm2", &signed_area_mm2, "positive for outer curves, negative for holes");
  contour.def_property_readonly("perimeter_mm", &perimeter_mm, "length of the closed curve");
  contour.def("__len__", [](const Contour& self) { return self.points_mm.size(); });
  contour.def("__repr__", [](const Contour& self) {
    return "<Contour, " + std::to_string(self.points_mm.size()) + " points, depth " + std::to_string(self.depth) + ">";
  });
}

void bind_contour_slice(py::module_& core) {
  py::class_<ContourSlice> slice(core, "ContourSlice",
                                 "What one slice says about one organ. Without contours the organ is absent here: "
                                 "everything within the field of view is outside.");
  slice.def(py::init([](std::vector<Contour> contours, const SlicePose& pose, const Eigen::Vector2i& size_pixels,
                        std::string name) {
              orient_by_nesting(contours);
              return ContourSlice{std::move(name), pose, size_pixels, std::move(contours)};
            }),
            py::arg("contours") = std::vector<Contour>(), py::arg("pose") = SlicePose(),
            py::arg("size_pixels") = Eigen::Vector2i(Eigen::Vector2i::Zero()), py::arg("name") = "",
            "The contours are copied, and oriented and given their depths by which encloses which.");
  slice.def_readwrite("name", &ContourSlice::name, "names the slice in messages");
  slice.def_readwrite("pose", &ContourSlice::pose, "where the slice lies, world LPS mm");
  slice.def_property_readonly(
      "size_pixels", [](const ContourSlice& self) { return self.size_pixels; },
      "columns and rows of the image; 0, 0: unknown extent");
  slice.def_property_readonly(
      "contours", [](const py::object& self) { return references(self.cast<ContourSlice&>().contours, self); },
      "the contours themselves, not copies");
  slice.def(
      "is_inside",
      [](const ContourSlice& self, const Eigen::Vector2d& point) { return is_inside(self.contours, point); },
      py::arg("point_in_slice_mm"), "Whether an odd number of the contours encloses a point (slice mm).");
  slice.def(
      "signed_distance_mm",
      [](const ContourSlice& self, const Eigen::Vector2d& point) { return signed_distance_mm(self.contours, point); },
      py::arg("point_in_slice_mm"), "Distance of a point (slice mm) to the nearest curve, mm, positive inside.");
  slice.def_property_readonly(
      "area_mm2",
      [](const ContourSlice& self) {
        return std::accumulate(self.contours.begin(), self.contours.end(), 0.0,
                               [](double sum, const Contour& c) { return sum + signed_area_mm2(c); });
      },
      "what the contours enclose, holes taken away");
  slice.def("__repr__", [](const ContourSlice& self) {
    return "<ContourSlice '" + self.name + "', " + std::to_string(self.contours.size()) + " contours>";
  });
}

void bind_contour_stack(py::module_& core) {
  py::class_<ContourStack> stack(core, "ContourStack",
                                 "All contours of one organ. len(), iteration, organ[3] (a slice), organ[::4] and "
                                 "organ[[0, 8]] (the organ on these slices).");
  stack.def(py::init([](std::vector<ContourSlice> slices, std::string name, std::optional<Color> color,
                        std::string roi_type) {
              return ContourStack{std::move(name), std::move(slices), color, std::move(roi_type)};
            }),
            py::arg("slices") = std::vector<ContourSlice>(), py::arg("name") = "", py::arg("color") = py::none(),
            py::arg("roi_type") = "", "The slices are copied.");
  stack.def_readwrite("name", &ContourStack::name, "of the organ");
  stack.def_readwrite("color", &ContourStack::color, "(red, green, blue), 0 to 255, or None");
  stack.def_readwrite("roi_type", &ContourStack::roi_type, "DICOM RT ROI Interpreted Type such as ORGAN");
  stack.def_property_readonly(
      "slices", [](const py::object& self) { return references(self.cast<ContourStack&>().slices, self); },
      "the slices themselves, not copies");
  stack.def_property_readonly("point_count", &point_count, "points of all contours; 0: the organ is drawn nowhere");
  stack.def("__len__", [](const ContourStack& self) { return self.slices.size(); });
  stack.def(
      "__getitem__",
      [](ContourStack& self, py::ssize_t index) -> ContourSlice& {
        return self.slices[item_number(index, self.slices.size())];
      },
      py::arg("index"), py::return_value_policy::reference_internal);
  const auto with = [](const ContourStack& self, std::vector<ContourSlice> slices) {
    return ContourStack{self.name, std::move(slices), self.color, self.roi_type};
  };
  stack.def(
      "__getitem__",
      [with](const ContourStack& self, const py::slice& range) { return with(self, chosen(self.slices, range)); },
      py::arg("index"));
  stack.def(
      "__getitem__",
      [with](const ContourStack& self, const std::vector<py::ssize_t>& numbers) {
        return with(self, chosen(self.slices, numbers));
      },
      py::arg("index"));
  stack.def("__iter__",
            [](const py::object& self) { return py::iter(references(self.cast<ContourStack&>().slices, self)); });
  stack.def("__repr__", [](const ContourStack& self) {
    return "<ContourStack '" + self.name + "', " + std::to_string(self.slices.size()) + " slices, " +
           std::to_string(point_count(self)) + " points>";
  });
}

}  // namespace

void bind_contours(py::module_& core) {
  bind_contour(core);
  bind_contour_slice(core);
  bind_contour_stack(core);
}

}  // namespace isostack::python
