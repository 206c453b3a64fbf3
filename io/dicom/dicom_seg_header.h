#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/dicom/dicom_header.h"
#include "recon/geometry/label_map.h"

namespace isostack {

enum class SegmentationType { kBinary, kFractional, kLabelMap };

/// A DICOM segmentation without its pixels.
struct SegmentationHeader {
  DicomHeader image;  ///< with frame_parts
  SegmentationType type = SegmentationType::kBinary;
  int fractional_maximum = 255;                         ///< stored value that stands for 1
  std::vector<Segment> segments;                        ///< value: segment number; layer: 0
  std::map<std::uint16_t, std::string> property_types;  ///< by segment number: what it is, such as "Liver"
  std::vector<std::uint16_t> segment_of_frame;          ///< segment number; none for label maps
  std::string plain_pixels;                             ///< of deflated files, whose pixels cannot be read directly
  std::vector<std::string> warnings;
};

/// Throws InputError naming the file.
SegmentationHeader read_segmentation_header(const std::filesystem::path& path);

}  // namespace isostack
