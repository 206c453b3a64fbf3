#pragma once

#include <gdcmReader.h>

#include <filesystem>
#include <sstream>

#include "io/dicom/dicom_start.h"

namespace isostack {

/// GDCM's reader of a file, or of a file whose preamble or meta header are missing: those are put before it, for
/// GDCM would guess how it is written. Walk over the file first (walk_dicom).
class DicomReader {
 public:
  explicit DicomReader(const std::filesystem::path& path);
  DicomReader(const std::filesystem::path& path, const DicomStart& start);

  gdcm::Reader& operator*() { return reader_; }
  gdcm::Reader* operator->() { return &reader_; }

 private:
  std::istringstream completed_;  ///< only of such files
  gdcm::Reader reader_;
};

}  // namespace isostack
