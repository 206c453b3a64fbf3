#include "io/inspect.h"

#include "python/bindings.h"
#include "python/struct_class.h"

namespace isostack::python {

void bind_inspect(py::module_& core) {
  StructClass<GapSummary>(core, "GapSummary", "Distances between neighbouring slices along their normal.\n")
      .result("smallest_mm", &GapSummary::smallest_mm, "mm")
      .result("median_mm", &GapSummary::median_mm, "mm")
      .result("largest_mm", &GapSummary::largest_mm, "mm")
      .done_as_result();
  StructClass<OrganSummary>(core, "OrganSummary", "One organ of a structure set or a segmentation.\n")
      .result("name", &OrganSummary::name, "of the organ")
      .result("type", &OrganSummary::type, "DICOM RT ROI Interpreted Type, or SegmentedPropertyType")
      .result("color", &OrganSummary::color, "(red, green, blue), 0 to 255, or None")
      .result("slice_count", &OrganSummary::slice_count, "slices with contours")
      .result("contour_count", &OrganSummary::contour_count, "contours")
      .result("point_count", &OrganSummary::point_count, "points of all contours")
      .result("number", &OrganSummary::number, "of a segment; 0: not one")
      .result("voxel_count", &OrganSummary::voxel_count, "of a segment, where pixels need not be decoded")
      .done_as_result();
  using S = SeriesSummary;
  StructClass<S>(core, "SeriesSummary",
                 "What is in a file, or in one series of a folder. Nothing in it identifies a patient.\n")
      .result("number", &S::number, "what ReadOptions.series takes; 0 where there is nothing to choose")
      .result("kind", &S::kind, "\"DICOM\", \"NIfTI\", \"mesh\", \"contours\", ...")
      .result("name", &S::name, "file name or organ; empty for DICOM")
      .result("modality", &S::modality, "\"CT\", \"MR\", ...")
      .result("series_uid", &S::series_uid, "DICOM SeriesInstanceUID")
      .result("encoding", &S::encoding, "DICOM: the transfer syntax; otherwise the file format")
      .result("value_type", &S::value_type, "as stored: \"int16\", \"float\", ...")
      .result("slice_count", &S::slice_count, "of one phase")
      .result("phase_count", &S::phase_count, "pictures at one place, what ReadOptions.phase chooses from")
      .result("columns", &S::columns, "of the first slice")
      .result("rows", &S::rows, "of the first slice")
      .result("slice_thickness_mm", &S::slice_thickness_mm, "DICOM, mm, or None")
      .result("smallest_spacing_mm", &S::smallest_spacing_mm, "column and row distance, over all slices, mm")
      .result("largest_spacing_mm", &S::largest_spacing_mm, "column and row distance, over all slices, mm")
      .result("row_direction", &S::row_direction, "of growing column index, world LPS, first slice")
      .result("column_direction", &S::column_direction, "of growing row index, world LPS, first slice")
      .result("orientation", &S::orientation, "nearest patient directions of columns, rows, slices, such as \"LPS\"")
      .result("gaps", &S::gaps, "between neighbouring slices, or None")
      .result("tilt_deg", &S::tilt_deg, "between the line of slice origins and the normal, degrees")
      .result("extent_mm", &S::extent_mm, "along rows, along columns, first to last slice centre, mm")
      .result("vertex_count", &S::vertex_count, "of a mesh")
      .result("triangle_count", &S::triangle_count, "of a mesh")
      .result("contour_count", &S::contour_count, "of contours")
      .result("point_count", &S::point_count, "of contours")
      .result("organs", &S::organs, "of structure sets and segmentations")
      .result("lower_mm", &S::lower_mm, "corner of the box round it, world LPS mm")
      .result("upper_mm", &S::upper_mm, "opposite corner, world LPS mm")
      .result("warnings", &S::warnings, "problems that were found")
      .done_as_result();
  core.def("inspect", &inspect, py::arg("path"), py::call_guard<py::gil_scoped_release>(),
           "What a folder or file holds, one summary per series, without decoding pixels.");
}

}  // namespace isostack::python
