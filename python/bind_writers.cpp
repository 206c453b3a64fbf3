#include "io/contours/contour_files.h"
#include "io/dicom/write_dicom.h"
#include "io/images/write_pictures.h"
#include "io/meshes/write_mesh.h"
#include "io/volumes/volume_files.h"
#include "python/bindings.h"
#include "python/casters.h"

namespace isostack::python {

namespace py = pybind11;
namespace fs = std::filesystem;

void bind_writers(py::module_& core) {
  const py::call_guard<py::gil_scoped_release> unlocked;
  core.def("write_mesh", &write_mesh, py::arg("mesh"), py::arg("path"), py::arg("options") = WriteOptions(), unlocked);
  core.def("write_contours", &write_contours, py::arg("organs"), py::arg("path"), py::arg("options") = WriteOptions(),
           unlocked);
  core.def("write_labels", &write_labels, py::arg("labels"), py::arg("path"), py::arg("options") = WriteOptions(),
           unlocked);
  core.def(
      "write_volume",
      [](const Volume<float>& volume, const fs::path& path, const WriteOptions& options) {
        write_volume(stored_volume_of(volume), path, options);
      },
      py::arg("volume"), py::arg("path"), py::arg("options") = WriteOptions(), unlocked);
  core.def(
      "write_distances",
      [](const Volume<float>& volume, const fs::path& path, const WriteOptions& options) {
        write_volume(stored_distances_of(volume), path, options);
      },
      py::arg("volume"), py::arg("path"), py::arg("options") = WriteOptions(), unlocked);
  core.def(
      "convert_volume",
      [](const fs::path& input, const fs::path& output, const WriteOptions& options) {
        write_volume(read_stored_volume(input), output, options);
      },
      py::arg("input"), py::arg("output"), py::arg("options") = WriteOptions(), unlocked);
  core.def(
      "write_dicom_series",
      [](const SliceStack& stack, const fs::path& folder, std::uint64_t seed, const std::string& description) {
        write_dicom_series(stack, folder, {.seed = seed, .description = description});
      },
      py::arg("stack"), py::arg("folder"), py::arg("seed") = 1, py::arg("description") = "synthetic phantom", unlocked);
}

}  // namespace isostack::python
