#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/dicom_start.h"
#include "recon/geometry/slice_pose.h"

namespace isostack {

/// What kind of object a DICOM file holds, as far as this library cares.
enum class DicomKind { kImage, kSegmentation, kStructureSet, kOther };

/// What orders pictures of one place in time or contrast; each as far as the header has it.
struct DicomTiming {
  std::optional<double> temporal_position;  ///< TemporalPositionIdentifier or TemporalPositionIndex
  std::optional<double> trigger_time_ms;
  std::optional<double> acquisition_s;  ///< date and time as one number; only differences mean anything
  std::optional<double> echo_time_ms;
  std::optional<double> instance_number;
};

/// Where one picture lies and what its stored values mean.
struct DicomFrame {
  std::optional<Eigen::Vector3d> position_mm;                                 ///< ImagePositionPatient
  std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> row_and_column;  ///< ImageOrientationPatient
  std::optional<Eigen::Vector2d> spacing_mm;  ///< PixelSpacing, turned into (column distance, row distance)
  std::optional<double> slice_thickness_mm;
  std::optional<double> spacing_between_slices_mm;
  double slope = 1;
  double intercept = 0;
  DicomTiming timing;
};

/// The part of one DICOM file's header that decides how its pixels are read and where they lie.
/// Nothing in it identifies a patient.
struct DicomHeader : DicomFrame {
  std::filesystem::path path;
  std::string name;  ///< file name, for messages; for one frame of many with its number
  DicomKind kind = DicomKind::kOther;
  std::string series_uid;
  std::string modality;
  std::string transfer_syntax;  ///< its name, such as "JPEG 2000 Image Compression"
  std::string photometric;      ///< "MONOCHROME2", ...
  int columns = 0;
  int rows = 0;
  int frames = 1;                       ///< in the file
  int frame = 0;                        ///< which of them this header describes, from 0
  std::vector<DicomFrame> frame_parts;  ///< one per frame of a multi-frame file whose header places its frames
  int samples_per_pixel = 1;
  int bits_allocated = 0;
  int bits_stored = 0;
  int high_bit = 0;
  bool is_signed = false;
  bool is_compressed = false;         ///< pixels are encapsulated
  int swapped_bytes = 0;              ///< uncompressed pixels: of this many bytes each group is turned round; 0: none
  bool is_localizer = false;          ///< a projection of many slices, as CT scouts are
  bool was_compressed_lossy = false;  ///< at any time
  std::string instance_uid;
  std::string frame_of_reference_uid;
  std::uintmax_t pixel_offset = 0;  ///< of uncompressed pixels in the file, bytes; 0 where they cannot be read directly
  std::uintmax_t pixel_bytes = 0;   ///< of uncompressed pixels
};

/// One header for each picture in the file: the header itself, or one per frame with that frame's parts.
/// Throws InputError naming the file when it has several frames and does not say where they lie.
std::vector<DicomHeader> frames_of(const DicomHeader& header);

/// True when its extension (.dcm, .ima) says that it is DICOM.
bool is_called_dicom(const std::filesystem::path& path);

/// Reads the header up to the pixel data. Throws InputError naming the file when it is cut off or
/// is not valid DICOM.
DicomHeader read_dicom_header(const std::filesystem::path& path);

/// The slice's pose. Throws InputError naming the file when position, orientation or spacing is
/// missing, GeometryError when they make no sense.
SlicePose pose_of(const DicomHeader& header);

}  // namespace isostack
