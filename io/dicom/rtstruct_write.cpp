#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/dicom/dicom_reference.h"
#include "io/dicom/dicom_text.h"
#include "io/dicom/rtstruct.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr const char* structure_set_storage = "1.2.840.10008.5.1.4.1.1.481.3";
constexpr const char* study_class = "1.2.840.10008.3.1.2.3.1";  // Detached Study Management, as is customary
constexpr int digits_of_mm = 4;

using DataSets = std::vector<gdcm::DataSet>;

/// Colours for organs that have none; neighbours differ.
Color color_for(std::size_t index) {
  static constexpr Color colors[] = {{230, 80, 60},  {70, 150, 230},  {110, 190, 80}, {240, 180, 50}, {160, 100, 210},
                                     {60, 190, 180}, {230, 120, 180}, {150, 120, 90}, {200, 200, 80}, {120, 130, 230}};
  return colors[index % std::size(colors)];
}

gdcm::DataSet contour_item(const Contour& contour, const SlicePose& pose, const ReferencedImage* image) {
  DataSetBuilder data;
  if (image) data.sequence({0x3006, 0x0016}, {image_reference(*image)});
  data.text({0x3006, 0x0042}, gdcm::VR::CS, "CLOSED_PLANAR");
  data.text({0x3006, 0x0046}, gdcm::VR::IS, std::to_string(contour.points_mm.size()));
  std::vector<double> coordinates;
  for (const Eigen::Vector2d& point : contour.points_mm)
    for (const double coordinate : pose.slice_to_world(point)) coordinates.push_back(coordinate);
  data.decimals({0x3006, 0x0050}, coordinates, digits_of_mm);
  return data.result();
}

gdcm::DataSet contours_of(const ContourStack& organ, std::size_t index, const ReferencedSeries& series) {
  DataSetBuilder data;
  const Color color = organ.color.value_or(color_for(index));
  data.text({0x3006, 0x002a}, gdcm::VR::IS, fmt::format("{}\\{}\\{}", color.red, color.green, color.blue));
  DataSets contours;
  for (const ContourSlice& slice : organ.slices) {
    if (slice.contours.empty()) continue;
    const ReferencedImage* image = image_in_plane(slice.pose, series);
    for (const Contour& contour : slice.contours) contours.push_back(contour_item(contour, slice.pose, image));
  }
  if (!contours.empty()) data.sequence({0x3006, 0x0040}, contours);
  data.text({0x3006, 0x0084}, gdcm::VR::IS, std::to_string(index + 1));
  return data.result();
}

gdcm::DataSet roi_item(const ContourStack& organ, std::size_t index, const ReferencedSeries& series) {
  DataSetBuilder data;
  data.text({0x3006, 0x0022}, gdcm::VR::IS, std::to_string(index + 1));
  data.text({0x3006, 0x0024}, gdcm::VR::UI, series.frame_of_reference_uid);
  data.text({0x3006, 0x0026}, gdcm::VR::LO, dicom_from_utf8(organ.name, 64));
  data.text({0x3006, 0x0036}, gdcm::VR::CS, "");  // how it came about is not known here
  return data.result();
}

gdcm::DataSet observation_item(const ContourStack& organ, std::size_t index) {
  DataSetBuilder data;
  data.text({0x3006, 0x0082}, gdcm::VR::IS, std::to_string(index + 1));
  data.text({0x3006, 0x0084}, gdcm::VR::IS, std::to_string(index + 1));
  data.text({0x3006, 0x00a4}, gdcm::VR::CS, dicom_from_utf8(organ.roi_type, 16));
  data.text({0x3006, 0x00a6}, gdcm::VR::PN, "");
  return data.result();
}

gdcm::DataSet frame_of_reference_item(const ReferencedSeries& series) {
  DataSetBuilder data;
  data.text({0x0020, 0x0052}, gdcm::VR::UI, series.frame_of_reference_uid);
  if (series.images.empty()) return data.result();
  std::map<std::string, DataSets> references;  // by series
  for (const ReferencedImage& image : series.images) {
    if (image.frame > 1) continue;  // a file of many frames is named once, as a whole
    ReferencedImage file = image;
    file.frame = 0;
    references[image.series_uid].push_back(image_reference(file));
  }
  DataSets all_series;
  for (const auto& [uid, images] : references) {
    DataSetBuilder item;
    item.text({0x0020, 0x000e}, gdcm::VR::UI, uid);
    item.sequence({0x3006, 0x0016}, images);
    all_series.push_back(item.result());
  }
  DataSetBuilder study;
  study.text({0x0008, 0x1150}, gdcm::VR::UI, study_class);
  study.text({0x0008, 0x1155}, gdcm::VR::UI, series.study_uid);
  study.sequence({0x3006, 0x0014}, all_series);
  data.sequence({0x3006, 0x0012}, {study.result()});
  return data.result();
}

/// What UIDs follow from: everything that is written of the organs.
std::string content_of(const std::vector<ContourStack>& organs) {
  std::string text;
  for (const ContourStack& organ : organs) {
    text += fmt::format("organ {} {}\n", organ.name, organ.roi_type);
    for (const ContourSlice& slice : organ.slices)
      for (const Contour& contour : slice.contours)
        for (const Eigen::Vector2d& point : contour.points_mm) {
          const Eigen::Vector3d place = slice.pose.slice_to_world(point);
          text += fmt::format("{:.4f} {:.4f} {:.4f}\n", place.x(), place.y(), place.z());
        }
  }
  return text;
}

ReferencedSeries no_series(const std::string& content) {
  ReferencedSeries series;
  series.study_uid = uid_from("study of " + content);
  series.frame_of_reference_uid = uid_from("frame of reference of " + content);
  return series;
}

void add_general(const ReferencedSeries& series, const std::string& content, const WriteOptions& options,
                 bool is_plain_text, DataSetBuilder& data) {
  const bool is_plain_patient = add_patient_and_study(series, options.identify, data);
  if (!is_plain_patient || !is_plain_text) data.text({0x0008, 0x0005}, gdcm::VR::CS, "ISO_IR 192");  // UTF-8
  data.text({0x0008, 0x0016}, gdcm::VR::UI, structure_set_storage);
  data.text({0x0008, 0x0018}, gdcm::VR::UI, uid_from("instance of " + series.study_uid + content));
  data.text({0x0008, 0x0060}, gdcm::VR::CS, "RTSTRUCT");
  data.text({0x0008, 0x0070}, gdcm::VR::LO, "isostack");
  data.text({0x0008, 0x1070}, gdcm::VR::PN, "");  // operators
  data.text({0x0020, 0x000e}, gdcm::VR::UI, uid_from("series of " + series.study_uid + content));
  data.text({0x0020, 0x0011}, gdcm::VR::IS, "");
  data.text({0x0020, 0x0052}, gdcm::VR::UI, series.frame_of_reference_uid);
  data.text({0x0020, 0x1040}, gdcm::VR::LO, "");  // position reference
  data.text({0x3006, 0x0002}, gdcm::VR::SH, "isostack");
  data.text({0x3006, 0x0008}, gdcm::VR::DA, "");
  data.text({0x3006, 0x0009}, gdcm::VR::TM, "");
}

}  // namespace

void write_rtstruct(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                    const WriteOptions& options) {
  if (organs.empty()) throw InputError(path.string(), "there is no organ to write", "give contours of at least one");
  if (options.identify && !options.like)
    throw InputError(path.string(), "there is no image series to take the patient from", "give one with --like");
  const std::string content = content_of(organs);
  const ReferencedSeries series = options.like ? referenced_series(options) : no_series(content);
  const bool is_plain_text = std::all_of(organs.begin(), organs.end(), [](const auto& o) { return is_ascii(o.name); });
  DataSetBuilder data;
  add_general(series, content, options, is_plain_text, data);
  data.sequence({0x3006, 0x0010}, {frame_of_reference_item(series)});
  DataSets rois, contours, observations;
  for (std::size_t i = 0; i < organs.size(); ++i) {
    rois.push_back(roi_item(organs[i], i, series));
    contours.push_back(contours_of(organs[i], i, series));
    observations.push_back(observation_item(organs[i], i));
  }
  data.sequence({0x3006, 0x0020}, rois);
  data.sequence({0x3006, 0x0039}, contours);
  data.sequence({0x3006, 0x0080}, observations);
  data.text({0x300e, 0x0002}, gdcm::VR::CS, "UNAPPROVED");
  // Coordinates of a long contour do not fit into the length that explicit VRs allow.
  write_dicom_file(data.result(), path, gdcm::TransferSyntax::ImplicitVRLittleEndian);
}

}  // namespace isostack
