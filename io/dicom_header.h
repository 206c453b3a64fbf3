#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

#include "recon/geometry/slice_pose.h"

namespace isostack {

/// What kind of object a DICOM file holds, as far as this library cares.
enum class DicomKind { kImage, kSegmentation, kStructureSet, kOther };

/// The part of one DICOM file's header that decides how its pixels are read and where they lie.
/// Nothing in it identifies a patient.
struct DicomHeader {
  std::filesystem::path path;
  std::string name;  ///< file name, for messages
  DicomKind kind = DicomKind::kOther;
  std::string series_uid;
  std::string modality;
  std::string transfer_syntax;  ///< its name, such as "JPEG 2000 Image Compression"
  std::string photometric;      ///< "MONOCHROME2", ...
  int columns = 0;
  int rows = 0;
  int frames = 1;
  int samples_per_pixel = 1;
  int bits_allocated = 0;
  int bits_stored = 0;
  bool is_signed = false;
  double slope = 1;
  double intercept = 0;
  std::optional<Eigen::Vector3d> position_mm;                                 ///< ImagePositionPatient
  std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> row_and_column;  ///< ImageOrientationPatient
  std::optional<Eigen::Vector2d> spacing_mm;  ///< PixelSpacing, turned into (column distance, row distance)
  std::optional<double> slice_thickness_mm;
  std::optional<double> spacing_between_slices_mm;
};

/// True when the file has DICOM's magic bytes ("DICM" at 128).
bool has_dicom_magic(const std::filesystem::path& path);

/// Reads the header up to the pixel data. Throws InputError naming the file when it is cut off or
/// is not valid DICOM.
DicomHeader read_dicom_header(const std::filesystem::path& path);

/// The slice's pose. Throws InputError naming the file when position, orientation or spacing is
/// missing, GeometryError when they make no sense.
SlicePose pose_of(const DicomHeader& header);

}  // namespace isostack
