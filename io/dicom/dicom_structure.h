#pragma once

#include <cstdint>
#include <filesystem>

#include "io/dicom/dicom_start.h"

namespace isostack {

/// What walking over a DICOM file's elements, without decoding any, tells.
struct DicomStructure {
  bool is_whole = true;  ///< false: an element reaches beyond the end of the file, or is not one
  bool has_pixels = false;
  bool is_deflated = false;
  bool pixels_are_words = false;                     ///< VR OW
  std::uintmax_t pixel_offset = 0, pixel_bytes = 0;  ///< in the file; 0 unless the pixels are there as they are
};

/// Walks over all elements up to the pixel data, also those in sequences. GDCM's own checks end the
/// program on files that are cut off or damaged, so every file is walked first; a
/// deflated data set is inflated for that.
DicomStructure walk_dicom(const std::filesystem::path& path, const DicomStart& start);

}  // namespace isostack
