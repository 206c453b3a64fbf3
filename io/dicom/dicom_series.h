#pragma once

#include "io/dicom/dicom_scan.h"
#include "io/read_slices.h"
#include "io/stack_geometry.h"

namespace isostack {

/// The pictures of an image series in the order of order_along_normals, with their poses; those of
/// one phase when there are several.
struct OrderedSeries {
  std::vector<DicomHeader> files;  ///< one per picture: multi-frame files come as one header per frame
  std::vector<SlicePose> poses;
  int phase_count = 1;
  std::string phases_by;             ///< what tells the phases apart, such as "TriggerTime"; empty when there is one
  std::vector<std::string> remarks;  ///< warnings about what was left out
};

/// `phase` is one of several pictures of the same places, from 1; none: there must be one picture at
/// each place. Copies of one picture count once, and localizers (projections) are left out. Pictures of a scene of all
/// series that cannot be used as slices are left out with a remark.
/// Throws InputError or GeometryError naming the file when a slice is coloured, has no valid pose
/// or does not have the size of the others of its series and direction, when several slices lie at
/// one place and no phase is chosen, or when there is no such phase.
OrderedSeries order_series(const DicomSeries& series, std::optional<int> phase = std::nullopt);

/// Warnings about geometry and grey values of the series.
std::vector<std::string> series_warnings(const OrderedSeries& series);

/// Reads one image series from a DICOM file or a folder (and its subfolders), single-frame or multi-frame. Slices are
/// ordered by their positions, never by their numbers; grey values have the header's rescale applied. Damaged files of
/// a folder are left out with a warning as long as others are left.
/// Throws InputError or GeometryError naming the file or folder.
SliceStack read_dicom_slices(const std::filesystem::path& path, const ReadOptions& options, const Progress& progress);

}  // namespace isostack
