#include "python/arrays.h"
#include "python/bindings.h"
#include "python/progress.h"
#include "python/sequences.h"
#include "segmentation/label_sections.h"
#include "segmentation/organs.h"
#include "segmentation/rasterize.h"
#include "segmentation/segment.h"
#include "segmentation/small_contours.h"
#include "segmentation/trace_contours.h"

namespace isostack::python {

namespace {

py::tuple distance_views(const py::object& self) {
  auto& organs = self.cast<SegmentedOrgans&>().distances_mm;
  py::tuple all(organs.size());
  for (std::size_t i = 0; i < organs.size(); ++i) {
    py::tuple slices(organs[i].size());
    for (std::size_t k = 0; k < organs[i].size(); ++k) slices[k] = image_view(organs[i][k], self);
    all[i] = slices;
  }
  return all;
}

std::vector<Contour> trace(const py::object& phi, const Eigen::Vector2d& spacing_mm) {
  const py::array array = checked_array(phi, py::dtype::of<float>(), 2, "phi");
  const Image<float> image =
      Eigen::Map<const Image<float>>(static_cast<const float*>(array.data()), array.shape(0), array.shape(1));
  return trace_contours(image, spacing_mm);
}

}  // namespace

void bind_segmentation(py::module_& core) {
  py::class_<SegmentedOrgans> segmented(core, "SegmentedOrgans", "What segment_organs found.");
  segmented.def_property_readonly(
      "organs", [](const py::object& self) { return references(self.cast<SegmentedOrgans&>().organs, self); },
      "one ContourStack per organ, on all slices, also those without it");
  segmented.def_property_readonly("distances_mm", &distance_views,
                                  "per organ and slice: (rows, columns) float32 signed distance in mm, positive "
                                  "inside, a view; empty unless asked for");
  segmented.def_property_readonly(
      "remarks", [](const SegmentedOrgans& self) { return copies(self.remarks); },
      "what a user should look at, naming slices");
  core.def(
      "segment",
      [](const SliceStack& images, const SegmentationOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return segment(images, options, p); });
      },
      py::arg("images"), py::arg("options"), py::arg("progress") = py::none());
  core.def(
      "segment_organs",
      [](const SliceStack& images, const OrganOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return segment_organs(images, options, p); });
      },
      py::arg("images"), py::arg("options"), py::arg("progress") = py::none());
  core.def(
      "trace_label",
      [](const SliceStack& images, int label, const LabelOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return trace_label(images, label, options, p); });
      },
      py::arg("images"), py::arg("label"), py::arg("options") = LabelOptions(), py::arg("progress") = py::none());
  core.def("labels_in", &labels_in, py::arg("images"), py::call_guard<py::gil_scoped_release>(),
           "Labels other than 0 in a stack of label images, ascending.");
  core.def(
      "label_sections",
      [](const LabelMap& labels, const std::vector<Segment>& segments, const std::vector<ContourSlice>& planes,
         const LabelOptions& options, const py::object& progress) {
        return without_lock(progress,
                            [&](const Progress& p) { return label_sections(labels, segments, planes, options, p); });
      },
      py::arg("labels"), py::arg("segments"), py::arg("planes"), py::arg("options") = LabelOptions(),
      py::arg("progress") = py::none());
  core.def(
      "rasterize",
      [](const ContourStack& organ, LabelVolume& labels, std::uint16_t label) { rasterize(organ, label, labels); },
      py::arg("organ"), py::arg("labels"), py::arg("label") = 1, py::call_guard<py::gil_scoped_release>(),
      "Sets the voxels of `labels` whose centre lies within the organ's contours to `label`, on the k-planes that "
      "coincide with a slice.");
  core.def("trace_contours", &trace, py::arg("phi"), py::arg("spacing_mm"),
           "Zero level curves of an image (rows, columns), inside where it is >= 0, as contours in slice mm.");
  core.def("remark_on_one_pixel_contours", &remark_on_one_pixel_contours, py::arg("organ"),
           "A sentence about contours round one pixel; empty without any.");
}

}  // namespace isostack::python
