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
  /// Column, row and slice distance of PNG/TIFF stacks, which carry none.
  std::optional<Eigen::Vector3d> spacing_mm = std::nullopt;
};

/// Reads a DICOM folder or file, NIfTI, NRRD, MetaImage or a folder of PNG/TIFF images.
/// Every slice keeps its own pose. Parallel DICOM slices come ordered along their normal, a volume's
/// in the order of its third index.
/// Throws InputError or GeometryError naming the file or slice and the remedy.
SliceStack read_slices(const std::filesystem::path& path, const ReadOptions& options = {},
                       const Progress& progress = {});

}  // namespace isostack
