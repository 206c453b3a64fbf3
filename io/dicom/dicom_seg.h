#pragma once

#include <filesystem>
#include <vector>

#include "io/write_options.h"
#include "recon/geometry/label_map.h"

namespace isostack {

/// True when the file is a DICOM segmentation. Files that are not DICOM or are damaged are not.
bool is_dicom_seg(const std::filesystem::path& path);

/// Reads a DICOM Segmentation (PS3.3, A.51) of type BINARY, FRACTIONAL (inside: at least half of
/// MaximumFractionalValue) or LABELMAP. A segment keeps its number as value, its label and its colour; segments that
/// overlap come in several layers. Frames may come in any order, and a segment is absent where it has none; the grid
/// reaches from the first to the last plane with a frame, along their normal. Throws InputError naming the file
/// when it is damaged, GeometryError when its frames do not lie on one even grid.
LabelMap read_dicom_seg(const std::filesystem::path& path);

/// The same for frames anywhere: where they lie on no even grid (uneven gaps, several orientations, shifted planes)
/// one map of a single plane for each place, in the order of order_along_normals; otherwise one map. Warnings are the
/// first one's.
std::vector<LabelMap> read_dicom_seg_planes(const std::filesystem::path& path);

/// Its grid alone, without decoding pixels.
Grid read_dicom_seg_grid(const std::filesystem::path& path);

/// Writes a BINARY segmentation. A segment has a frame on every plane that it reaches; the first and the last plane
/// of the grid always have one, so that the grid comes back. options.like, an image series, gives study and frame of
/// reference, and each frame names the image in whose plane it lies. Patient name, ID and the like are empty unless
/// options.identify. Equal input gives an equal file but for the time it was made.
/// Throws InputError naming the file when it cannot be written, is empty, or `like` is not an image series.
void write_dicom_seg(const LabelMap& labels, const std::filesystem::path& path, const WriteOptions& options = {});

}  // namespace isostack
