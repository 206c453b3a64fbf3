#include "io/contours/contour_files.h"
#include "io/dicom/dicom_header.h"
#include "io/dicom/series_planes.h"
#include "io/formats.h"
#include "io/meshes/read_mesh.h"
#include "io/read_slices.h"
#include "io/solid_file.h"
#include "io/volumes/volume_files.h"
#include "python/bindings.h"
#include "python/casters.h"
#include "python/progress.h"

namespace isostack::python {

namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

/// What read() makes of a file; the names of the reading verbs.
std::string kind_of(const fs::path& path) {
  const bool is_file = fs::is_regular_file(path);
  if (is_file && holds_solid(path)) return "solid";
  if (is_file && holds_contours(path)) return "contours";
  if (is_file && find_format(path, &Format::read_mesh) != nullptr) return "mesh";
  if (is_file && find_format(path, &Format::read_volume) != nullptr && !looks_like_dicom(path))
    return path.filename().string().ends_with(".seg.nrrd") ? "labels" : "volume";
  return is_file && may_hold_labels(path) ? "labels" : "slices";
}

}  // namespace

void bind_readers(py::module_& core) {
  const py::call_guard<py::gil_scoped_release> unlocked;
  core.def("kind_of", &kind_of, py::arg("path"), unlocked,
           "What read() takes a path for: slices, volume, labels, contours, mesh or solid.");
  core.def(
      "read_slices",
      [](const fs::path& path, const ReadOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return read_slices(path, options, p); });
      },
      py::arg("path"), py::arg("options") = ReadOptions(), py::arg("progress") = py::none());
  core.def(
      "read_contours",
      [](const fs::path& path, const ReadOptions& options) {
        ContourFile file = read_contour_file(path, options);
        return std::pair(std::move(file.organs), std::move(file.warnings));
      },
      py::arg("path"), py::arg("options") = ReadOptions(), unlocked);
  core.def("read_mesh", &read_mesh, py::arg("path"), py::arg("axes") = MeshAxes::lps, unlocked);
  core.def("read_volume", &read_volume, py::arg("path"), unlocked);
  core.def("read_grid", &read_grid, py::arg("path"), py::arg("options") = ReadOptions(), unlocked);
  core.def("read_labels", &read_labels, py::arg("path"), unlocked);
  core.def("read_label_planes", &read_label_planes, py::arg("path"), unlocked);
  core.def(
      "series_planes",
      [](const fs::path& like, const std::string& series) {
        return series_planes({.like = like, .like_series = series});
      },
      py::arg("like"), py::arg("series") = "", unlocked);
}

}  // namespace isostack::python
