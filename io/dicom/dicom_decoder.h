#pragma once

#include <memory>

#include "io/dicom/dicom_header.h"

namespace isostack {

/// Decodes pictures with GDCM. Damaged ones may end the program: use it in a child process.
class DicomDecoder {
 public:
  DicomDecoder();
  ~DicomDecoder();

  /// Writes rows * columns values, with the rescale applied, to `pixels`. Returns false when they
  /// cannot be decoded. The last file stays open for its other frames.
  bool decode(const DicomHeader& header, float* pixels);

 private:
  struct OpenFile;
  std::unique_ptr<OpenFile> open_;
};

}  // namespace isostack
