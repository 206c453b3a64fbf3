#include "python/arrays.h"
#include "python/bindings.h"
#include "python/sequences.h"
#include "recon/geometry/slice.h"
#include "recon/geometry/volume.h"

namespace isostack::python {

namespace {

Image<float> image_from(const py::object& pixels) {
  const py::array array = checked_array(pixels, py::dtype::of<float>(), 2, "pixels");
  if (array.size() == 0) return {};
  return Eigen::Map<const Image<float>>(static_cast<const float*>(array.data()), array.shape(0), array.shape(1));
}

void bind_slice(py::module_& core) {
  py::class_<Slice> slice(core, "Slice",
                          "Pixels at their place in the patient. Grey values are in the modality's units (CT: HU); "
                          "label images hold whole numbers, 0 = background.");
  slice.def(py::init([](const py::object& pixels, const SlicePose& pose, const std::string& name) {
              return Slice{.name = name, .pose = pose, .pixels = image_from(pixels)};
            }),
            py::arg("pixels"), py::arg("pose") = SlicePose(), py::arg("name") = "",
            "pixels: (rows, columns) of real numbers, copied.");
  slice.def_readwrite("name", &Slice::name, "names the slice in messages");
  slice.def_readwrite("pose", &Slice::pose, "where the slice lies, world LPS mm");
  slice.def_property(
      "pixels", [](const py::object& self) { return image_view(self.cast<Slice&>().pixels, self); },
      [](const py::object& self, const py::object& values) {
        assign_in_place(image_view(self.cast<Slice&>().pixels, self), values, "pixels");
      },
      "(rows, columns) float32, a view");
  slice.def("__repr__", [](const Slice& self) {
    return "<Slice '" + self.name + "', " + std::to_string(self.pixels.rows()) + " rows, " +
           std::to_string(self.pixels.cols()) + " columns>";
  });
}

SliceStack joined(const SliceStack& a, const SliceStack& b) {
  SliceStack result = a;
  result.slices.insert(result.slices.end(), b.slices.begin(), b.slices.end());
  result.warnings.insert(result.warnings.end(), b.warnings.begin(), b.warnings.end());
  return result;
}

void bind_stack(py::module_& core) {
  py::class_<SliceStack> stack(
      core, "SliceStack",
      "Slices of one scene, parallel or not, evenly spaced or not. len(), iteration, stack[3] "
      "(a slice), stack[::4] and stack[[0, 8]] (a stack of these), a + b (one scene of both).");
  stack.def(py::init([](std::vector<Slice> slices, std::string name, std::vector<std::string> warnings) {
              return SliceStack{std::move(name), std::move(slices), std::move(warnings)};
            }),
            py::arg("slices") = std::vector<Slice>(), py::arg("name") = "",
            py::arg("warnings") = std::vector<std::string>(), "The slices are copied.");
  stack.def_readwrite("name", &SliceStack::name, "free of patient data");
  stack.def_property_readonly(
      "slices", [](const py::object& self) { return references(self.cast<SliceStack&>().slices, self); },
      "the slices themselves, not copies");
  stack.def_property_readonly(
      "warnings", [](const SliceStack& self) { return copies(self.warnings); },
      "what a user must know before trusting the stack");
  stack.def("__len__", [](const SliceStack& self) { return self.slices.size(); });
  stack.def(
      "__getitem__",
      [](SliceStack& self, py::ssize_t index) -> Slice& { return self.slices[item_number(index, self.slices.size())]; },
      py::arg("index"), py::return_value_policy::reference_internal);
  stack.def(
      "__getitem__",
      [](const SliceStack& self, const py::slice& range) {
        return SliceStack{self.name, chosen(self.slices, range), self.warnings};
      },
      py::arg("index"));
  stack.def(
      "__getitem__",
      [](const SliceStack& self, const std::vector<py::ssize_t>& numbers) {
        return SliceStack{self.name, chosen(self.slices, numbers), self.warnings};
      },
      py::arg("index"));
  stack.def("__iter__",
            [](const py::object& self) { return py::iter(references(self.cast<SliceStack&>().slices, self)); });
  stack.def("__add__", &joined, py::arg("other"));
  stack.def("grid", &grid_of,
            "The grid whose k-planes these slices are. Raises GeometryError unless they are parallel, of one size and "
            "evenly spaced.");
  stack.def("__repr__", [](const SliceStack& self) {
    return "<SliceStack '" + self.name + "', " + std::to_string(self.slices.size()) + " slices>";
  });
}

}  // namespace

void bind_slices(py::module_& core) {
  bind_slice(core);
  bind_stack(core);
}

}  // namespace isostack::python
