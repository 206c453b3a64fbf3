#pragma once

#include <gdcmDataSet.h>

#include <filesystem>
#include <string>
#include <vector>

#include "io/dicom/dicom_builder.h"
#include "io/write_options.h"
#include "recon/geometry/slice_pose.h"

namespace isostack {

/// One image that a written object refers to.
struct ReferencedImage {
  std::string series_uid, class_uid, instance_uid;
  int frame = 0;  ///< from 1; 0 in files of one frame
  SlicePose pose;
  Eigen::Vector2i size_pixels = Eigen::Vector2i::Zero();
  std::string name;  ///< of the file, for messages
};

/// The image series, usually one, that a written object belongs to.
struct ReferencedSeries {
  std::string study_uid, frame_of_reference_uid;
  std::string series_uid;               ///< of the first image
  std::vector<ReferencedImage> images;  ///< in order of position along the normal where parallel
  gdcm::DataSet first_header;  ///< of one of its files, without pixels: source of the patient and study modules
};

/// Reads the series that options.like and options.like_series name. Throws InputError when it is no image series, when
/// there are several (unless "all" of one frame of reference are wanted), or when a UID or pose is missing.
ReferencedSeries referenced_series(const WriteOptions& options);

/// The image in whose plane (to 0.1 mm) the pose lies; null when there is none.
const ReferencedImage* image_in_plane(const SlicePose& pose, const ReferencedSeries& series);

/// Adds the patient and study modules. Without `identify` or without a series, names, IDs and dates are empty. Returns
/// whether all is ASCII; otherwise it is UTF-8, which the data set's SpecificCharacterSet must say.
bool add_patient_and_study(const ReferencedSeries& series, bool identify, DataSetBuilder& data);

/// Item of a sequence of referenced images (ReferencedSOPClassUID, ReferencedSOPInstanceUID, frame).
gdcm::DataSet image_reference(const ReferencedImage& image);

}  // namespace isostack
