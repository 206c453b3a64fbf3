#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "recon/geometry/slice.h"

namespace isostack {

/// How a synthetic DICOM series is written.
struct DicomSeriesOptions {
  std::uint64_t seed = 1;                         ///< all UIDs follow from it: the same seed gives the same bytes
  std::string description = "synthetic phantom";  ///< SeriesDescription
  int series_number = 1;                          ///< SeriesNumber
  std::optional<double> slice_thickness_mm = std::nullopt;  ///< SliceThickness; left empty when unknown
  double rescale_slope = 1;  ///< stored = round((value - rescale_intercept) / rescale_slope)
  double rescale_intercept = 0;
};

/// Writes the slices as CT Image Storage files slice_0001.dcm ... into the folder, which is made if
/// need be; uncompressed 16-bit, each slice with its own pose, patient name PHANTOM, no dates.
/// Throws InputError naming the folder or file when it cannot be written, GeometryError naming a
/// slice that has no pixels, and InputError naming a slice whose values do not fit into 16 bits.
void write_dicom_series(const SliceStack& stack, const std::filesystem::path& folder,
                        const DicomSeriesOptions& options = {});

}  // namespace isostack
