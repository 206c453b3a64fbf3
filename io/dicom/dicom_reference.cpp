#include "io/dicom/dicom_reference.h"

#include <algorithm>
#include <cmath>

#include "io/dicom/dicom_reader.h"
#include "io/dicom/dicom_scan.h"
#include "io/dicom/dicom_text.h"
#include "io/dicom/dicom_values.h"
#include "io/slice_order.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

gdcm::DataSet header_data(const DicomHeader& file) {
  DicomReader reader(file.path);
  const gdcm::Tag pixel_data(0x7fe0, 0x0010);
  if (!reader->ReadUpToTag(pixel_data))
    throw InputError(file.name, "the DICOM file is cut off or damaged", "copy the file again");
  return reader->GetFile().GetDataSet();
}

void require(const std::string& uid, const std::string& name, const DicomHeader& file) {
  if (uid.empty())
    throw InputError(file.name, "the image has no " + name + ", so nothing can refer to it",
                     "repair its header or give another series with --like");
}

}  // namespace

ReferencedSeries referenced_series(const WriteOptions& options) {
  const DicomScan scan = scan_dicom(*options.like);
  const DicomSeries chosen = select_series(scan, options.like_series, options.like->string());
  const DicomHeader& first = chosen.files.front();
  ReferencedSeries series;
  series.first_header = header_data(first);
  series.study_uid = dicom_text(series.first_header, 0x0020000d);
  series.series_uid = first.series_uid;
  series.frame_of_reference_uid = first.frame_of_reference_uid;
  std::string class_uid, series_uid;
  std::vector<ReferencedImage> images;
  for (const DicomHeader& file : chosen.files) {
    require(file.series_uid, "SeriesInstanceUID", file);
    require(file.instance_uid, "SOPInstanceUID", file);
    if (file.frame_of_reference_uid != first.frame_of_reference_uid)
      throw InputError(file.name, "it lies in another frame of reference than " + first.name,
                       "choose one series with --like-series");
    if (file.series_uid != series_uid) class_uid = dicom_text(header_data(file), 0x00080016);
    series_uid = file.series_uid;
    for (const DicomHeader& frame : frames_of(file))
      images.push_back({file.series_uid,
                        class_uid,
                        file.instance_uid,
                        file.frames > 1 ? frame.frame + 1 : 0,
                        pose_of(frame),
                        {frame.columns, frame.rows},
                        frame.name});
  }
  std::vector<SlicePose> poses;
  for (const ReferencedImage& image : images) poses.push_back(image.pose);
  for (const std::size_t i : order_along_normals(poses)) series.images.push_back(std::move(images[i]));
  if (series.study_uid.empty()) series.study_uid = uid_from("study of " + first.series_uid);
  // Objects of one frame of reference lie in the same coordinates; images without one are a frame of their own.
  if (series.frame_of_reference_uid.empty())
    series.frame_of_reference_uid = uid_from("frame of reference of " + first.series_uid);
  return series;
}

const ReferencedImage* image_in_plane(const SlicePose& pose, const ReferencedSeries& series) {
  constexpr double same_plane_mm = 0.1;
  const ReferencedImage* best = nullptr;
  double best_mm = same_plane_mm;
  for (const ReferencedImage& image : series.images) {
    const double distance_mm = std::abs(image.pose.signed_distance_mm(pose.origin_mm));
    if (!are_parallel(image.pose, pose) || distance_mm > best_mm) continue;
    best = &image;
    best_mm = distance_mm;
  }
  return best;
}

bool add_patient_and_study(const ReferencedSeries& series, bool identify, DataSetBuilder& data) {
  struct Field {
    DicomTag tag;
    gdcm::VR::VRType vr;
  };
  static constexpr Field fields[] = {
      {0x00100010, gdcm::VR::PN}, {0x00100020, gdcm::VR::LO},  // patient's name and ID
      {0x00100030, gdcm::VR::DA}, {0x00100040, gdcm::VR::CS},  // birth date, sex
      {0x00080020, gdcm::VR::DA}, {0x00080030, gdcm::VR::TM},  // study date and time
      {0x00080090, gdcm::VR::PN}, {0x00200010, gdcm::VR::SH},  // referring physician, study ID
      {0x00080050, gdcm::VR::SH},                              // accession number
  };
  const std::string character_set = dicom_text(series.first_header, 0x00080005);
  bool is_plain = true;
  for (const auto& [tag, vr] : fields) {
    const std::string text = identify ? utf8_from_dicom(dicom_text(series.first_header, tag), character_set) : "";
    is_plain = is_plain && is_ascii(text);
    data.text(gdcm::Tag(tag), vr, text);
  }
  data.text({0x0020, 0x000d}, gdcm::VR::UI, series.study_uid);
  return is_plain;
}

gdcm::DataSet image_reference(const ReferencedImage& image) {
  DataSetBuilder data;
  data.text({0x0008, 0x1150}, gdcm::VR::UI, image.class_uid);
  data.text({0x0008, 0x1155}, gdcm::VR::UI, image.instance_uid);
  if (image.frame > 0) data.text({0x0008, 0x1160}, gdcm::VR::IS, std::to_string(image.frame));
  return data.result();
}

}  // namespace isostack
