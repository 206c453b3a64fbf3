#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/dicom/dicom_header.h"
#include "recon/geometry/progress.h"

namespace isostack {

/// The files of one series, in natural order of their paths.
struct DicomSeries {
  std::string uid;
  std::string modality;
  DicomKind kind = DicomKind::kOther;
  std::vector<DicomHeader> files;
  bool is_scene = false;  ///< all image series together
};

/// What a folder holds. A series' number, as users see it, is its index plus one.
struct DicomScan {
  std::vector<DicomSeries> series;   ///< images first, each kind in natural order of its first path
  std::vector<std::string> damaged;  ///< one message for each DICOM file whose header cannot be read
};

/// Reads the headers of a DICOM file, or of all DICOM files in a folder and below. Files that
/// are not DICOM (find_dicom_start) are skipped. Throws InputError when the path cannot be read.
DicomScan scan_dicom(const std::filesystem::path& path, const Progress& progress = {});

/// The image series meant by `wanted`: its number, its UID or the end of its UID; empty when there
/// is only one; "all" for the files of all image series as one scene. Throws InputError listing the
/// series when that is ambiguous or matches none.
DicomSeries select_series(const DicomScan& scan, const std::string& wanted, const std::string& where);

/// The end of a UID that is shown to users.
std::string uid_ending(const std::string& uid);

}  // namespace isostack
