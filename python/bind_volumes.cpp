#include "python/arrays.h"
#include "python/bindings.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/volume.h"

namespace isostack::python {

namespace {

py::array::ShapeContainer shape_of(const Grid& grid) { return {grid.size.z(), grid.size.y(), grid.size.x()}; }

template <class T>
py::array voxels_view(const py::object& self) {
  auto& volume = self.cast<Volume<T>&>();
  return py::array_t<T>(shape_of(volume.grid), volume.voxels.empty() ? nullptr : volume.voxels.data(), self);
}

template <class T>
Volume<T> volume_from(const py::object& voxels, const Eigen::Matrix4d& index_to_world) {
  const py::array array = checked_array(voxels, py::dtype::of<T>(), 3, "voxels");
  if (array.ndim() != 3) throw InputError("voxels", "it is empty", "give an array of shape (k, j, i)");
  Grid grid;
  grid.size = {static_cast<int>(array.shape(2)), static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0))};
  grid.index_to_world.matrix() = index_to_world;
  Volume<T> volume(grid);
  std::copy_n(static_cast<const T*>(array.data()), array.size(), volume.voxels.begin());
  return volume;
}

template <class T>
void bind_volume(py::module_& core, const char* name, const char* about, const char* of_voxels) {
  py::class_<Volume<T>> volume(core, name, about);
  volume.def(py::init([](const Grid& grid, T value) { return Volume<T>(grid, value); }), py::arg("grid"),
             py::arg("value") = T{}, "All voxels hold the value.");
  volume.def(py::init(&volume_from<T>), py::arg("voxels"),
             py::arg("index_to_world") = Eigen::Matrix4d(Eigen::Matrix4d::Identity()),
             "voxels: of shape (k, j, i), copied; index_to_world: 4 × 4 from (i, j, k) to world LPS mm.");
  volume.def_property_readonly(
      "grid", [](const Volume<T>& self) { return self.grid; }, "where the voxels are, world LPS mm; a copy");
  volume.def_property(
      "voxels", &voxels_view<T>,
      [](const py::object& self, const py::object& values) { assign_in_place(voxels_view<T>(self), values, "voxels"); },
      of_voxels);
  volume.def("__repr__", [name](const Volume<T>& self) {
    const Eigen::Vector3i& size = self.grid.size;
    return "<" + std::string(name) + ", " + std::to_string(size.x()) + " × " + std::to_string(size.y()) + " × " +
           std::to_string(size.z()) + " voxels>";
  });
  volume.def("__copy__", [](const Volume<T>& self) { return Volume<T>(self); });
  volume.def(
      "__deepcopy__", [](const Volume<T>& self, const py::dict&) { return Volume<T>(self); }, py::arg("memo"));
}

}  // namespace

void bind_volumes(py::module_& core) {
  bind_volume<float>(core, "Volume", "Real values on a grid: grey values, or signed distances in mm, positive inside.",
                     "float32 of shape (k, j, i), i fastest, a view: voxels[k, j, i]");
  bind_volume<std::uint16_t>(core, "LabelVolume", "Whole numbers on a grid; 0 is background.",
                             "uint16 of shape (k, j, i), i fastest, a view: voxels[k, j, i]");
  core.def(
      "slices_of",
      [](const Volume<float>& volume, const std::string& name) {
        return SliceStack{name, slices_of(volume, name), {}};
      },
      py::arg("volume"), py::arg("name") = "volume",
      "The k-planes of a volume as slices named \"<name> slice <k>\", each with its pose. Pixels are copied.");
  core.def(
      "volume_of",
      [](const SliceStack& stack) {
        Volume<float> volume(grid_of(stack));
        auto voxel = volume.voxels.begin();
        for (const Slice& slice : stack.slices)
          voxel = std::copy(slice.pixels.data(), slice.pixels.data() + slice.pixels.size(), voxel);
        return volume;
      },
      py::arg("stack"),
      "The slices as one volume, k from slice to slice. Raises GeometryError unless they are parallel, of one size and "
      "evenly spaced. Pixels are copied.");
}

}  // namespace isostack::python
