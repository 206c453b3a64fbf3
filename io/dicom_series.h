#pragma once

#include "io/dicom_scan.h"
#include "io/read_slices.h"
#include "io/stack_geometry.h"

namespace isostack {

/// The files of an image series in the order of order_along_normals, with their poses.
struct OrderedSeries {
  std::vector<DicomHeader> files;
  std::vector<SlicePose> poses;
};

/// Throws InputError or GeometryError naming the file when a slice is coloured, has no valid pose
/// or does not have the size of the others, or when two slices lie at the same place.
OrderedSeries order_series(const DicomSeries& series);

/// Warnings about geometry and grey values of the series.
std::vector<std::string> series_warnings(const OrderedSeries& series);

/// Reads one image series from a DICOM file or a folder (and its subfolders). Slices are ordered
/// by their positions, never by their numbers; grey values have the header's rescale applied.
/// Throws InputError or GeometryError naming the file or folder.
SliceStack read_dicom_slices(const std::filesystem::path& path, const ReadOptions& options, const Progress& progress);

}  // namespace isostack
