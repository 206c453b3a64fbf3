#pragma once

#include <filesystem>

namespace isostack {

/// What walking over a DICOM file's elements, without decoding any, tells.
struct DicomStructure {
  bool is_whole = true;  ///< false: an element reaches beyond the end of the file
  bool has_pixels = false;
};

/// GDCM's own checks end the program on files that are cut off, so every file is walked first.
/// Deflated data sets and elements of unknown form end the walk; the rest is left to GDCM.
DicomStructure walk_dicom(const std::filesystem::path& path);

}  // namespace isostack
