#include "python/arrays.h"
#include "python/bindings.h"
#include "python/struct_class.h"
#include "recon/geometry/slice_pose.h"
#include "recon/geometry/volume.h"

namespace isostack::python {

namespace {

Grid make_grid(const Eigen::Vector3i& size, const Eigen::Matrix4d& index_to_world) {
  Grid grid;
  grid.size = size;
  grid.index_to_world.matrix() = index_to_world;
  return grid;
}

void bind_pose(py::module_& core) {
  auto pose = StructClass<SlicePose>(core, "SlicePose",
                                     "Where a slice lies in the patient (DICOM LPS, mm). Three frames: pixel (x = "
                                     "column, y = row, centres at whole numbers), slice (mm from the centre of pixel "
                                     "(0, 0) along the axes) and world.\n")
                  .field("origin_mm", &SlicePose::origin_mm, "world place of the centre of pixel (0, 0), LPS mm")
                  .field("x_axis", &SlicePose::x_axis, "unit direction of growing column index, world")
                  .field("y_axis", &SlicePose::y_axis, "unit direction of growing row index, world")
                  .field("spacing_mm", &SlicePose::spacing_mm, "pixel distance along x_axis and y_axis")
                  .done();
  pose.def_property_readonly("normal", &SlicePose::normal, "x_axis × y_axis, world");
  pose.def("slice_to_world", &SlicePose::slice_to_world, py::arg("point_in_slice_mm"), "Slice mm to world mm.");
  pose.def("world_to_slice", &SlicePose::world_to_slice, py::arg("point_in_world_mm"),
           "Orthogonal projection onto the plane: world mm to slice mm.");
  pose.def("pixel_to_slice", &SlicePose::pixel_to_slice, py::arg("pixel"), "(column, row) to slice mm.");
  pose.def("slice_to_pixel", &SlicePose::slice_to_pixel, py::arg("point_in_slice_mm"), "Slice mm to (column, row).");
  pose.def("pixel_to_world", &SlicePose::pixel_to_world, py::arg("pixel"), "(column, row) to world mm.");
  pose.def("signed_distance_mm", &SlicePose::signed_distance_mm, py::arg("point_in_world_mm"),
           "Distance of a world point to the plane, mm, positive on the side of the normal.");
  core.def("checked_pose", &checked_pose, py::arg("pose"), py::arg("where"),
           "The pose with its axes re-orthonormalised. Raises GeometryError naming `where` unless they nearly are and "
           "the spacing is positive.");
}

void bind_grid(py::module_& core) {
  py::class_<Grid> grid(core, "Grid",
                        "A regular lattice of voxel centres; index (i, j, k) maps to world LPS mm. The map may be "
                        "sheared along k (gantry tilt); i and j are perpendicular.");
  grid.def(py::init(&make_grid), py::arg("size"),
           py::arg("index_to_world") = Eigen::Matrix4d(Eigen::Matrix4d::Identity()),
           "size: voxels along i, j, k; index_to_world: 4 × 4, homogeneous, mm.");
  grid.def_property_readonly(
      "size", [](const Grid& self) { return self.size; }, "voxels along i, j, k");
  grid.def_property_readonly(
      "index_to_world", [](const Grid& self) { return Eigen::Matrix4d(self.index_to_world.matrix()); },
      "4 × 4 homogeneous matrix from voxel indices (i, j, k) to world LPS mm; a copy");
  grid.def_property_readonly("voxel_count", &Grid::voxel_count, "voxels in all");
  grid.def_property_readonly("voxel_volume_mm3", &Grid::voxel_volume_mm3, "volume of a voxel, mm³");
  grid.def("pose_of_plane", &pose_of_plane, py::arg("k"), py::arg("where") = "grid", "The pose of the k-th k-plane.");
  grid.def(
      "__eq__",
      [](const Grid& a, const Grid& b) {
        return a.size == b.size && a.index_to_world.matrix() == b.index_to_world.matrix();
      },
      py::arg("other"));
  grid.def("__repr__", [](const Grid& self) {
    const py::object matrix = py::cast(Eigen::Matrix4d(self.index_to_world.matrix()));
    return "Grid(size=" + std::string(py::repr(py::cast(self.size).attr("tolist")())) +
           ", index_to_world=" + std::string(py::repr(matrix.attr("tolist")())) + ")";
  });
}

}  // namespace

void bind_poses(py::module_& core) {
  bind_pose(core);
  bind_grid(core);
}

}  // namespace isostack::python
