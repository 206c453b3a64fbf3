#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/color.h"

namespace isostack {

/// Distances between neighbouring slices along their normal, mm.
struct GapSummary {
  double smallest_mm = 0, median_mm = 0, largest_mm = 0;
};

/// Slices of one plane direction.
struct OrientationSummary {
  std::string letters;  ///< nearest patient directions of columns, rows, slices, such as "LPS"
  std::size_t slice_count = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< world LPS
};

/// One organ of a structure set or a segmentation.
struct OrganSummary {
  std::string name;
  std::string type;  ///< DICOM RT ROI Interpreted Type, or SegmentedPropertyType; empty: unknown
  std::optional<Color> color = std::nullopt;
  std::size_t slice_count = 0;  ///< with contours
  std::size_t contour_count = 0, point_count = 0;
  int number = 0;                                         ///< of a segment; 0: not one
  std::size_t frame_count = 0;                            ///< of a segment; of a label map those that show it
  std::optional<std::size_t> voxel_count = std::nullopt;  ///< of a segment, unless its pixels had to be decoded
};

/// What is in a file, or in one series of a folder. Fields that make no sense for the kind keep
/// their defaults. Nothing in it identifies a patient.
struct SeriesSummary {
  int number = 0;        ///< what --series takes; 0 where there is nothing to choose
  std::string kind;      ///< "DICOM", "NIfTI", "NRRD", "MetaImage", "images", "mesh", "contours", ...
  std::string name;      ///< file name or organ; empty for DICOM
  std::string modality;  ///< "CT", "MR", ...
  std::string series_uid;
  std::string encoding;    ///< DICOM: name of the transfer syntax; otherwise the file format
  std::string value_type;  ///< as stored: "int16", "float", ...

  std::size_t slice_count = 0;               ///< of one phase
  int phase_count = 1;                       ///< DICOM: pictures at one place, what --phase chooses from
  std::string phases_by;                     ///< what tells phases apart, such as "TriggerTime"
  std::optional<double> slice_thickness_mm;  ///< DICOM
  int columns = 0, rows = 0;                 ///< of the first slice
  Eigen::Vector2d smallest_spacing_mm = Eigen::Vector2d::Zero();  ///< column, row distance over all slices
  Eigen::Vector2d largest_spacing_mm = Eigen::Vector2d::Zero();
  Eigen::Vector3d row_direction = Eigen::Vector3d::Zero();     ///< of growing column index, world LPS, first slice
  Eigen::Vector3d column_direction = Eigen::Vector3d::Zero();  ///< of growing row index
  std::string orientation;                       ///< nearest patient directions of columns, rows, slices, such as "LPS"
  int orientation_count = 0;                     ///< different plane directions
  std::vector<OrientationSummary> orientations;  ///< each of them, in the order of the slices
  std::optional<GapSummary> gaps;                ///< none for single slices
  double tilt_deg = 0;                           ///< between the line of slice origins and the normal
  Eigen::Vector3d extent_mm = Eigen::Vector3d::Zero();  ///< along rows, along columns, first to last slice centre

  std::size_t vertex_count = 0, triangle_count = 0;  ///< meshes
  std::size_t contour_count = 0, point_count = 0;    ///< contours
  std::vector<OrganSummary> organs;                  ///< of structure sets and segmentations
  Eigen::Vector3d lower_mm = Eigen::Vector3d::Zero(), upper_mm = Eigen::Vector3d::Zero();  ///< world LPS bounds

  std::vector<std::string> warnings;
};

/// Looks at a DICOM folder or file, volume, image folder, mesh or contour file without decoding
/// pixels. Damaged DICOM files and series that cannot be read as slices are told in warnings.
/// Throws InputError naming the path when there is nothing readable at all.
std::vector<SeriesSummary> inspect(const std::filesystem::path& path);

/// The patient direction nearest to the vector: L, P, S or the opposite R, A, I.
char direction_letter(const Eigen::Vector3d& direction);

}  // namespace isostack
