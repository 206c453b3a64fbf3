#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace isostack {

/// Where the elements of a DICOM file begin, and how they are written where the file does not say.
struct DicomStart {
  std::uintmax_t offset = 0;   ///< of the first element, bytes
  std::string guessed_syntax;  ///< transfer syntax UID; empty when the file has a meta header, which tells it
};

/// Looks for preamble and "DICM", or without them for a meta header (group 0002) or a data set of group 0008 right at
/// the beginning, as old archives and some planning systems write it. Without a meta header the first two elements
/// tell explicit from implicit VR and the byte order. None: it is not DICOM.
std::optional<DicomStart> find_dicom_start(const std::filesystem::path& path);

/// True when find_dicom_start finds one.
bool looks_like_dicom(const std::filesystem::path& path);

/// The preamble and meta header that the file lacks, to be put in place of its first start.offset bytes; empty when
/// nothing is missing.
std::string missing_start(const DicomStart& start);

}  // namespace isostack
