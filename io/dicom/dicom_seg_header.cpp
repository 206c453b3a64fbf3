#include "io/dicom/dicom_seg_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <set>

#include "io/dicom/cielab.h"
#include "io/dicom/dicom_frames.h"
#include "io/dicom/dicom_reader.h"
#include "io/dicom/dicom_text.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr DicomTag segment_sequence = 0x00620002, segment_number = 0x00620004, segment_label = 0x00620005,
                   property_type = 0x0062000f, segment_identification = 0x0062000a, referenced_segment = 0x0062000b,
                   shared_groups = 0x52009229, per_frame_groups = 0x52009230;
const gdcm::Tag pixel_data(0x7fe0, 0x0010);

[[noreturn]] void throw_damaged(const std::string& where, const std::string& problem) {
  throw InputError(where, problem, "the file is damaged; copy it again or export it anew");
}

std::optional<Color> color_of(const gdcm::DataSet& data) {
  const std::string_view value = dicom_bytes(data, 0x0062000d);
  DicomLab lab;
  if (value.size() < sizeof(lab)) return std::nullopt;
  std::memcpy(lab.data(), value.data(), sizeof(lab));
  return color_from_lab(lab);
}

std::string property_type_of(const gdcm::DataSet& data, const std::string& character_set) {
  std::string meaning;
  for (const gdcm::DataSet& code : dicom_items(data, property_type)) meaning = dicom_text(code, 0x00080104);
  return utf8_from_dicom(meaning, character_set);
}

std::string name_of(const gdcm::DataSet& data, int number, const std::string& character_set) {
  std::string name = utf8_from_dicom(dicom_text(data, segment_label), character_set);
  if (name.empty()) name = property_type_of(data, character_set);
  return name.empty() ? fmt::format("segment {}", number) : name;
}

void read_segments(const gdcm::DataSet& data, SegmentationHeader& header) {
  std::set<int> seen;
  const std::string character_set = dicom_text(data, 0x00080005);
  for (const gdcm::DataSet& item : dicom_items(data, segment_sequence)) {
    const int number = static_cast<int>(dicom_uint16(item, segment_number).value_or(0));
    if (number == 0 && header.type == SegmentationType::kLabelMap) continue;  // the background
    if (number == 0) throw_damaged(header.image.name, "one of its segments has no number");
    if (!seen.insert(number).second)
      throw_damaged(header.image.name, fmt::format("two of its segments have number {}", number));
    header.segments.push_back({.name = name_of(item, number, character_set),
                               .value = static_cast<std::uint16_t>(number),
                               .layer = 0,
                               .color = color_of(item)});
    header.property_types[static_cast<std::uint16_t>(number)] = property_type_of(item, character_set);
  }
}

/// The segment that an item of functional groups names, 0 if none.
std::uint16_t segment_in(const gdcm::DataSet& groups) {
  for (const gdcm::DataSet& identification : dicom_items(groups, segment_identification))
    return static_cast<std::uint16_t>(dicom_uint16(identification, referenced_segment).value_or(0));
  return 0;
}

void read_segment_of_frame(const gdcm::DataSet& data, SegmentationHeader& header) {
  std::uint16_t shared = 0;
  for (const gdcm::DataSet& groups : dicom_items(data, shared_groups)) shared = segment_in(groups);
  for (const gdcm::DataSet& groups : dicom_items(data, per_frame_groups)) {
    const std::uint16_t own = segment_in(groups), number = own != 0 ? own : shared;
    if (number == 0) throw_damaged(header.image.name, "a frame does not say which segment it belongs to");
    header.segment_of_frame.push_back(number);
    const bool described = std::any_of(header.segments.begin(), header.segments.end(),
                                       [&](const Segment& segment) { return segment.value == number; });
    if (described) continue;
    header.segments.push_back({.name = fmt::format("segment {}", number), .value = number});
    header.warnings.push_back(
        fmt::format("undescribed segment: frames refer to segment {}, which has no name", number));
  }
}

SegmentationType type_of(const gdcm::DataSet& data, const std::string& where) {
  const std::string type = dicom_text(data, 0x00620001);
  if (type == "BINARY") return SegmentationType::kBinary;
  if (type == "FRACTIONAL") return SegmentationType::kFractional;
  if (type == "LABELMAP") return SegmentationType::kLabelMap;
  throw InputError(where, "its segmentation type '" + type + "' is not supported", "export it as BINARY");
}

void require_plausible_pixels(const SegmentationHeader& header) {
  const DicomHeader& image = header.image;
  const int bits = image.bits_allocated;
  const bool known = bits == 1 || bits == 8 || (bits == 16 && header.type == SegmentationType::kLabelMap);
  if (!known || image.samples_per_pixel != 1)
    throw InputError(image.name, fmt::format("pixels of {} bits are not supported in a segmentation", bits),
                     "export it as BINARY");
  if (image.rows == 0 || image.columns == 0) throw_damaged(image.name, "it has no rows or columns");
  constexpr double strongest_compression = 20000;  // an empty picture in JPEG 2000
  const double claimed = 1.0 * image.rows * image.columns * image.frames * bits / 8;
  const double there = image.is_compressed
                           ? strongest_compression * static_cast<double>(std::filesystem::file_size(image.path))
                       : image.pixel_offset != 0 ? static_cast<double>(image.pixel_bytes)
                                                 : static_cast<double>(header.plain_pixels.size());
  if (claimed > there)
    throw_damaged(image.name, fmt::format("it claims {} frames of {} x {} pixels, {:.0f} bytes, and holds {:.0f} bytes",
                                          image.frames, image.columns, image.rows, claimed, there));
}

}  // namespace

SegmentationHeader read_segmentation_header(const std::filesystem::path& path) {
  SegmentationHeader header;
  header.image = read_dicom_header(path);
  const std::string& where = header.image.name;
  if (header.image.kind != DicomKind::kSegmentation)
    throw InputError(where, "it is DICOM, but no segmentation", "give a DICOM SEG file");
  DicomReader reader(path);
  const bool is_deflated = header.image.pixel_offset == 0 && !header.image.is_compressed;
  if (!(is_deflated ? reader->Read() : reader->ReadUpToTag(pixel_data, {pixel_data})))
    throw_damaged(where, "it cannot be read");
  const gdcm::DataSet& data = reader->GetFile().GetDataSet();
  header.type = type_of(data, where);
  header.fractional_maximum = static_cast<int>(dicom_uint16(data, 0x0062000e).value_or(255));
  if (is_deflated) header.plain_pixels = dicom_bytes(data, 0x7fe00010);
  require_plausible_pixels(header);
  read_segments(data, header);
  header.image.frame_parts = read_frame_parts(data, header.image);
  if (header.image.frame_parts.empty()) throw_damaged(where, "it does not say where its frames lie");
  if (header.type != SegmentationType::kLabelMap) read_segment_of_frame(data, header);
  return header;
}

}  // namespace isostack
