#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

#include "recon/geometry/progress.h"
#include "recon/geometry/slice.h"

namespace isostack {

struct ReadOptions {
  std::string series;  ///< which DICOM series: its number in `info`, its UID, or the end of its UID; empty: the only one
  std::optional<Eigen::Vector3d> spacing_mm;  ///< PNG/TIFF stacks, which carry none: column, row, slice distance
};

/// Reads a DICOM folder or file, NIfTI, NRRD, MetaImage or a folder of PNG/TIFF images.
/// Every slice keeps its own pose; parallel slices come ordered along their normal.
/// Throws InputError or GeometryError naming the file or slice and the remedy.
SliceStack read_slices(const std::filesystem::path& path, const ReadOptions& options = {},
                       const Progress& progress = {});

}  // namespace isostack
