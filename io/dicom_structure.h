#pragma once

#include <filesystem>

namespace isostack {

/// What walking over a DICOM file's elements, without decoding any, tells.
struct DicomStructure {
  bool is_whole = true;  ///< false: an element reaches beyond the end of the file, or is not one
  bool has_pixels = false;
};

/// Walks over all elements up to the pixel data, also those in sequences. GDCM's own checks end the
/// program on files that are cut off or damaged, so every file is walked first. Deflated data sets
/// are not looked into.
DicomStructure walk_dicom(const std::filesystem::path& path);

}  // namespace isostack
