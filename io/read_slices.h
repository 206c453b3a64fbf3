#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

#include "recon/geometry/progress.h"
#include "recon/geometry/slice.h"

namespace isostack {

struct ReadOptions {
  /// Which DICOM series: its number in `info`, its UID, or the end of its UID; "all": every image
  /// series, as one scene; empty: the only one.
  std::string series = {};
  /// Which of several DICOM pictures of the same places (heart phase, contrast phase, echo), from 1; none: there
  /// must be one picture at each place.
  std::optional<int> phase = std::nullopt;
  /// Column, row and slice distance of PNG/TIFF stacks, which carry none.
  std::optional<Eigen::Vector3d> spacing_mm = std::nullopt;
  /// RTSTRUCT: what lies within any contour of a slice is inside; otherwise what lies within an odd number of them.
  bool unite_contours = false;
  /// RTSTRUCT: the images it was drawn on, which tell on which planes an organ is absent and how far they
  /// reach; by default looked for in the folder of the file.
  std::optional<std::filesystem::path> images = std::nullopt;
};

/// Reads a DICOM folder or file, NIfTI, NRRD, MetaImage or a folder of PNG/TIFF images.
/// Every slice keeps its own pose. Parallel DICOM slices come ordered along their normal, a volume's
/// in the order of its third index.
/// Throws InputError or GeometryError naming the file or slice and the remedy.
SliceStack read_slices(const std::filesystem::path& path, const ReadOptions& options = {},
                       const Progress& progress = {});

}  // namespace isostack
