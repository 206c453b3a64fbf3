#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "io/dicom/cielab.h"
#include "io/dicom/dicom_reference.h"
#include "io/dicom/dicom_seg.h"
#include "io/dicom/dicom_seg_planes.h"
#include "io/dicom/dicom_text.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

using DataSets = std::vector<gdcm::DataSet>;

constexpr const char* segmentation_storage = "1.2.840.10008.5.1.4.1.1.66.4";
const gdcm::Tag segment_identification(0x0062, 0x000a), referenced_segment(0x0062, 0x000b),
    plane_position(0x0020, 0x9113), image_position(0x0020, 0x0032);

void add_pointer(const gdcm::Tag& tag, const gdcm::Tag& to, DataSetBuilder& data) {
  const std::uint16_t words[] = {to.GetGroup(), to.GetElement()};
  data.bytes(tag, gdcm::VR::AT, {reinterpret_cast<const char*>(words), sizeof(words)});
}

gdcm::DataSet code(const char* value, const char* scheme, const char* meaning) {
  DataSetBuilder data;
  data.text({0x0008, 0x0100}, gdcm::VR::SH, value);
  data.text({0x0008, 0x0102}, gdcm::VR::SH, scheme);
  data.text({0x0008, 0x0104}, gdcm::VR::LO, meaning);
  return data.result();
}

gdcm::DataSet segment_item(const Segment& segment) {
  DataSetBuilder data;
  const gdcm::DataSet tissue = code("85756007", "SCT", "Tissue");  // names alone do not tell more
  data.sequence({0x0062, 0x0003}, {tissue});
  data.number({0x0062, 0x0004}, segment.value);
  data.text({0x0062, 0x0005}, gdcm::VR::LO, dicom_from_utf8(segment.name, 64));
  data.text({0x0062, 0x0008}, gdcm::VR::CS, "SEMIAUTOMATIC");
  data.text({0x0062, 0x0009}, gdcm::VR::LO, "isostack");
  if (segment.color) {
    const DicomLab lab = lab_from_color(*segment.color);
    data.bytes({0x0062, 0x000d}, gdcm::VR::US, {reinterpret_cast<const char*>(lab.data()), sizeof(lab)});
  }
  data.sequence({0x0062, 0x000f}, {tissue});
  return data.result();
}

gdcm::DataSet shared_groups(const Grid& grid, const SlicePose& pose) {
  DataSetBuilder orientation, measures, data;
  const Eigen::Vector3d &x = pose.x_axis, &y = pose.y_axis;
  orientation.decimals({0x0020, 0x0037}, {x.x(), x.y(), x.z(), y.x(), y.y(), y.z()});
  const double spacing_mm = std::abs(grid.index_to_world.linear().col(2).dot(pose.normal()));
  measures.decimals({0x0018, 0x0050}, {spacing_mm});
  measures.decimals({0x0018, 0x0088}, {spacing_mm});
  measures.decimals({0x0028, 0x0030}, {pose.spacing_mm.y(), pose.spacing_mm.x()});  // distance between rows first
  data.sequence({0x0020, 0x9116}, {orientation.result()});
  data.sequence({0x0028, 0x9110}, {measures.result()});
  return data.result();
}

gdcm::DataSet derivation(const ReferencedImage& image) {
  DataSetBuilder source(image_reference(image)), data;
  source.sequence({0x0040, 0xa170}, {code("121322", "DCM", "Source image for image processing operation")});
  data.sequence({0x0008, 0x2112}, {source.result()});
  data.sequence({0x0008, 0x9215}, {code("113076", "DCM", "Segmentation")});
  return data.result();
}

gdcm::DataSet frame_groups(const SegmentPlane& frame, const SlicePose& pose, const ReferencedImage* image) {
  DataSetBuilder content, position, identification, data;
  const std::uint32_t indices[] = {frame.segment, static_cast<std::uint32_t>(frame.k + 1)};
  content.bytes({0x0020, 0x9157}, gdcm::VR::UL, {reinterpret_cast<const char*>(indices), sizeof(indices)});
  position.decimals(image_position, {pose.origin_mm.x(), pose.origin_mm.y(), pose.origin_mm.z()});
  identification.number(referenced_segment, frame.segment);
  if (image) data.sequence({0x0008, 0x9124}, {derivation(*image)});
  data.sequence({0x0020, 0x9111}, {content.result()});
  data.sequence(plane_position, {position.result()});
  data.sequence(segment_identification, {identification.result()});
  return data.result();
}

void add_dimensions(const std::string& organization_uid, DataSetBuilder& data) {
  DataSetBuilder organization;
  organization.text({0x0020, 0x9164}, gdcm::VR::UI, organization_uid);
  data.sequence({0x0020, 0x9221}, {organization.result()});
  DataSets indices;
  for (const auto& [pointer, group] :
       {std::pair(referenced_segment, segment_identification), std::pair(image_position, plane_position)}) {
    DataSetBuilder index;
    index.text({0x0020, 0x9164}, gdcm::VR::UI, organization_uid);
    add_pointer({0x0020, 0x9165}, pointer, index);
    add_pointer({0x0020, 0x9167}, group, index);
    indices.push_back(index.result());
  }
  data.sequence({0x0020, 0x9222}, indices);
}

void add_general(const ReferencedSeries& series, const std::string& content, bool identify, bool is_plain_text,
                 DataSetBuilder& data) {
  const bool is_plain_patient = add_patient_and_study(series, identify, data);
  if (!is_plain_patient || !is_plain_text) data.text({0x0008, 0x0005}, gdcm::VR::CS, "ISO_IR 192");  // UTF-8
  const auto now = fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now()));
  data.text({0x0008, 0x0008}, gdcm::VR::CS, "DERIVED\\PRIMARY");
  data.text({0x0008, 0x0016}, gdcm::VR::UI, segmentation_storage);
  data.text({0x0008, 0x0018}, gdcm::VR::UI, uid_from("instance of " + content));
  data.text({0x0008, 0x0023}, gdcm::VR::DA, fmt::format("{:%Y%m%d}", now));  // the standard wants to know
  data.text({0x0008, 0x0033}, gdcm::VR::TM, fmt::format("{:%H%M%S}", now));
  data.text({0x0008, 0x0060}, gdcm::VR::CS, "SEG");
  data.text({0x0008, 0x0070}, gdcm::VR::LO, "isostack");
  data.text({0x0008, 0x1090}, gdcm::VR::LO, "isostack");
  data.text({0x0018, 0x1000}, gdcm::VR::LO, "0");
  data.text({0x0018, 0x1020}, gdcm::VR::LO, "isostack");
  data.text({0x0020, 0x000e}, gdcm::VR::UI, uid_from("series of " + content));
  data.text({0x0020, 0x0011}, gdcm::VR::IS, "1");
  data.text({0x0020, 0x0013}, gdcm::VR::IS, "1");
  data.text({0x0020, 0x0052}, gdcm::VR::UI, series.frame_of_reference_uid);
  data.text({0x0020, 0x1040}, gdcm::VR::LO, "");
  data.text({0x0070, 0x0080}, gdcm::VR::CS, "SEGMENTATION");
  data.text({0x0070, 0x0081}, gdcm::VR::LO, "");
  data.text({0x0070, 0x0084}, gdcm::VR::PN, "");
}

void add_pixels(const Grid& grid, std::size_t frames, const std::string& bits, DataSetBuilder& data) {
  data.number({0x0028, 0x0002}, 1);
  data.text({0x0028, 0x0004}, gdcm::VR::CS, "MONOCHROME2");
  data.text({0x0028, 0x0008}, gdcm::VR::IS, std::to_string(frames));
  data.number({0x0028, 0x0010}, static_cast<std::uint16_t>(grid.size.y()));
  data.number({0x0028, 0x0011}, static_cast<std::uint16_t>(grid.size.x()));
  data.number({0x0028, 0x0100}, 1);
  data.number({0x0028, 0x0101}, 1);
  data.number({0x0028, 0x0102}, 0);
  data.number({0x0028, 0x0103}, 0);
  data.text({0x0028, 0x2110}, gdcm::VR::CS, "00");
  data.text({0x0062, 0x0001}, gdcm::VR::CS, "BINARY");
  data.bytes({0x7fe0, 0x0010}, gdcm::VR::OB, bits);
}

void add_source_series(const ReferencedSeries& series, const std::set<const ReferencedImage*>& used,
                       DataSetBuilder& data) {
  DataSets images;
  std::set<std::string> named;  // a file of many frames once, as a whole
  for (const ReferencedImage& image : series.images) {
    if (!used.contains(&image) || !named.insert(image.instance_uid).second) continue;
    ReferencedImage file = image;
    file.frame = 0;
    images.push_back(image_reference(file));
  }
  if (images.empty()) return;
  DataSetBuilder item;
  item.sequence({0x0008, 0x114a}, images);
  item.text({0x0020, 0x000e}, gdcm::VR::UI, series.series_uid);
  data.sequence({0x0008, 0x1115}, {item.result()});
}

/// What UIDs follow from: all that is written of the map.
std::string content_of(const SegmentPlanes& planes, const Grid& grid) {
  std::string text;
  for (const Segment& segment : planes.segments) text += fmt::format("{} {}\n", segment.value, segment.name);
  for (const double number : grid.index_to_world.matrix().reshaped()) text += fmt::format("{:.6f} ", number);
  for (const SegmentPlane& frame : planes.frames) text += fmt::format("{} {}\n", frame.segment, frame.k);
  return text + planes.bits;
}

ReferencedSeries source_of(const WriteOptions& options, const std::string& content) {
  if (options.like) return referenced_series(options);
  ReferencedSeries series;
  series.study_uid = uid_from("study of " + content);
  series.frame_of_reference_uid = uid_from("frame of reference of " + content);
  return series;
}

}  // namespace

void write_dicom_seg(const LabelMap& labels, const std::filesystem::path& path, const WriteOptions& options) {
  const SegmentPlanes planes = planes_of_segments(labels, path.string());
  const Grid& grid = labels.layers.front().grid;
  std::string content = content_of(planes, grid);
  const ReferencedSeries series = source_of(options, content);
  content += series.series_uid;
  DataSetBuilder data;
  const bool is_plain_text =
      std::all_of(planes.segments.begin(), planes.segments.end(), [](const Segment& s) { return is_ascii(s.name); });
  add_general(series, content, options.identify, is_plain_text, data);
  add_dimensions(uid_from("dimensions of " + content), data);
  add_pixels(grid, planes.frames.size(), planes.bits, data);
  DataSets segments, frames;
  for (const Segment& segment : planes.segments) segments.push_back(segment_item(segment));
  data.sequence({0x0062, 0x0002}, segments);
  data.text({0x0062, 0x0013}, gdcm::VR::CS, labels.layers.size() > 1 ? "YES" : "NO");
  data.sequence({0x5200, 0x9229}, {shared_groups(grid, pose_of_plane(grid, 0, path.string()))});
  std::set<const ReferencedImage*> used;
  for (const SegmentPlane& frame : planes.frames) {
    const SlicePose pose = pose_of_plane(grid, frame.k, path.string());
    const ReferencedImage* image = image_in_plane(pose, series);
    if (image) used.insert(image);
    frames.push_back(frame_groups(frame, pose, image));
  }
  data.sequence({0x5200, 0x9230}, frames);
  add_source_series(series, used, data);
  write_dicom_file(data.result(), path);
}

}  // namespace isostack
