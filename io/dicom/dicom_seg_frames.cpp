#include "io/dicom/dicom_seg_frames.h"

#include <algorithm>
#include <fstream>

#include "io/dicom/dicom_pixels.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

std::string plain_bytes(const DicomHeader& image) {
  std::string bytes(image.pixel_bytes, '\0');
  std::ifstream stream(image.path, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(image.pixel_offset));
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw InputError(image.name, "its pixels are cut off", "copy the file again");
  // Frames of single bits do not end at words, so all are turned round together.
  for (std::size_t group = static_cast<std::size_t>(image.swapped_bytes), i = 0; group > 1 && i + group <= bytes.size();
       i += group)
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                 bytes.begin() + static_cast<std::ptrdiff_t>(i + group));
  return bytes;
}

/// Stored values of the pictures, of 8 or 16 bits.
void append_stored(const std::vector<Image<float>>& pictures, int bits, std::string& bytes) {
  for (const Image<float>& picture : pictures)
    for (const float value : picture.reshaped<Eigen::RowMajor>()) {
      const auto stored = static_cast<std::uint16_t>(std::clamp(value, 0.0f, 65535.0f));
      bytes += static_cast<char>(stored & 255);
      if (bits == 16) bytes += static_cast<char>(stored >> 8);
    }
}

std::string decompressed_bytes(const DicomHeader& image) {
  if (image.bits_allocated == 1)
    throw InputError(image.name, "compressed pixels of one bit are not supported",
                     "decompress the file, or export it with pixels of 8 bits");
  std::vector<DicomHeader> frames = frames_of(image);
  for (DicomHeader& frame : frames) {  // numbers of segments, and fractions, are what is stored
    frame.slope = 1;
    frame.intercept = 0;
    frame.is_signed = false;
  }
  std::string bytes;
  constexpr std::size_t frames_at_once = 64;  // as floats they take much room
  for (std::size_t begin = 0; begin < frames.size(); begin += frames_at_once) {
    const auto end = std::min(frames.size(), begin + frames_at_once);
    append_stored(read_dicom_pixels({frames.begin() + static_cast<std::ptrdiff_t>(begin),
                                     frames.begin() + static_cast<std::ptrdiff_t>(end)}),
                  image.bits_allocated, bytes);
  }
  return bytes;
}

}  // namespace

SegmentationFrames::SegmentationFrames(const SegmentationHeader& header)
    : bits_(header.image.bits_allocated),
      pixels_per_frame_(static_cast<std::size_t>(header.image.rows) * static_cast<std::size_t>(header.image.columns)) {
  const DicomHeader& image = header.image;
  bytes_ = image.is_compressed       ? decompressed_bytes(image)
           : image.pixel_offset != 0 ? plain_bytes(image)
                                     : header.plain_pixels;
  const std::size_t values = pixels_per_frame_ * static_cast<std::size_t>(image.frames);
  if (bytes_.size() * 8 < values * static_cast<std::size_t>(bits_))
    throw InputError(image.name, "it has fewer pixels than its frames need", "copy the file again");
}

}  // namespace isostack
