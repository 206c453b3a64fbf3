#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/dicom/dicom_seg_header.h"

namespace isostack {

/// The pixels of a segmentation's frames. One-bit pixels are packed without gaps, so that a frame may begin within a
/// byte (PS3.5, 8.1.1); libraries that decode frame by frame do not read such files.
class SegmentationFrames {
 public:
  /// Throws InputError naming the file when the pixels cannot be read.
  explicit SegmentationFrames(const SegmentationHeader& header);

  /// Calls call(pixel, value) for the pixels of the frame that are not 0, row by row.
  template <class Call>
  void for_each_set(std::size_t frame, Call call) const {
    const std::size_t begin = frame * pixels_per_frame_, end = begin + pixels_per_frame_;
    for (std::size_t i = begin; i < end; ++i) {
      if (bits_ == 1 && i % 8 == 0)  // most bytes are empty
        while (i + 8 <= end && bytes_[i / 8] == 0) i += 8;
      if (i < end)
        if (const std::uint16_t value = value_at(i)) call(i - begin, value);
    }
  }

 private:
  std::uint16_t value_at(std::size_t i) const {
    if (bits_ == 1) return (static_cast<unsigned char>(bytes_[i / 8]) >> i % 8) & 1;
    if (bits_ == 8) return static_cast<unsigned char>(bytes_[i]);
    return static_cast<std::uint16_t>(static_cast<unsigned char>(bytes_[2 * i]) |
                                      static_cast<unsigned char>(bytes_[2 * i + 1]) << 8);
  }

  int bits_;
  std::size_t pixels_per_frame_;
  std::string bytes_;  ///< of all frames, little endian
};

}  // namespace isostack
