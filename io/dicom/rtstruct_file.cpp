#include "io/dicom/rtstruct_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "io/dicom/dicom_header.h"
#include "io/dicom/dicom_reader.h"
#include "io/dicom/dicom_text.h"
#include "io/dicom/dicom_values.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr DicomTag character_set = 0x00080005;
constexpr DicomTag series_uid = 0x0020000e, frames_of_reference = 0x30060010, studies = 0x30060012,
                   series_sequence = 0x30060014;
constexpr DicomTag roi_sequence = 0x30060020, roi_number = 0x30060022, roi_name = 0x30060026;
constexpr DicomTag roi_contours = 0x30060039, display_color = 0x3006002a, referenced_roi = 0x30060084,
                   contour_sequence = 0x30060040, geometric_type = 0x30060042, contour_data = 0x30060050;
constexpr DicomTag observations = 0x30060080, interpreted_type = 0x300600a4;

constexpr double farthest_mm = 1e9;
constexpr std::size_t most_points = 100'000;  // of one contour: a hundred times what is usual

[[noreturn]] void throw_damaged(const std::filesystem::path& path, const std::string& problem) {
  throw InputError(path.string(), problem, "export the structure set again or copy the file again");
}

/// ContourData may hold many thousands of numbers. Nothing unless all are numbers and make whole points.
std::vector<Eigen::Vector3d> points_from(const std::string& text) {
  std::vector<Eigen::Vector3d> points;
  std::size_t count = 0;
  for (std::size_t begin = 0; begin <= text.size(); ++count) {
    const std::size_t end = std::min(text.find('\\', begin), text.size());
    std::size_t first = text.find_first_not_of(" \t\r\n+", begin);
    first = std::min(first, end);
    double number = 0;
    const auto [rest, error] = std::from_chars(text.data() + first, text.data() + end, number);
    const bool is_number = error == std::errc() && std::abs(number) < farthest_mm &&
                           std::all_of(rest, text.data() + end, [](char c) { return c == ' ' || c == '\0'; });
    if (!is_number) return {};
    if (count % 3 == 0) points.emplace_back();
    points.back()[static_cast<int>(count % 3)] = number;
    begin = end + 1;
  }
  return count % 3 == 0 ? points : std::vector<Eigen::Vector3d>();
}

std::optional<Color> color_from(const std::vector<double>& channels) {
  const bool valid = channels.size() == 3 &&
                     std::all_of(channels.begin(), channels.end(), [](double c) { return c >= 0 && c <= 255; });
  if (!valid) return std::nullopt;
  const auto channel = [&](std::size_t i) { return static_cast<std::uint8_t>(channels[i]); };
  return Color{channel(0), channel(1), channel(2)};
}

std::vector<RtContour> contours_of(const gdcm::DataSet& roi, const std::string& name, RtStructureSet& set) {
  std::vector<RtContour> contours;
  std::size_t unreadable = 0, endless = 0;
  for (const gdcm::DataSet& item : dicom_items(roi, contour_sequence)) {
    RtContour contour{dicom_text(item, geometric_type), points_from(dicom_text(item, contour_data))};
    if (contour.points_mm.empty())
      ++unreadable;
    else if (contour.points_mm.size() > most_points)
      ++endless;
    else
      contours.push_back(std::move(contour));
  }
  if (unreadable > 0)
    set.warnings.push_back(
        fmt::format("{}: {} of its contours left out, for their coordinates are missing or damaged", name, unreadable));
  if (endless > 0)
    set.warnings.push_back(
        fmt::format("{}: {} of its contours left out, for they have more than {} points", name, endless, most_points));
  return contours;
}

/// Users and other files tell organs apart by name.
void make_names_unique(RtStructureSet& set) {
  std::set<std::string> taken;
  for (RtRoi& roi : set.rois) {
    const std::string name = roi.name;
    for (int n = 2; !taken.insert(roi.name).second; ++n) roi.name = fmt::format("{} ({})", name, n);
    if (roi.name != name)
      set.warnings.push_back(fmt::format("several ROIs are named {}; one is now {}", name, roi.name));
  }
}

/// Index of each ROI by its number.
std::map<std::string, std::size_t> read_names(const gdcm::DataSet& data, RtStructureSet& set) {
  std::map<std::string, std::size_t> index_of;
  const std::string encoding = dicom_text(data, character_set);
  for (const gdcm::DataSet& item : dicom_items(data, roi_sequence)) {
    const std::string number = dicom_text(item, roi_number);
    std::string name = utf8_from_dicom(dicom_text(item, roi_name), encoding);
    if (name.empty()) name = "ROI " + number;
    if (!index_of.try_emplace(number, set.rois.size()).second)
      set.warnings.push_back(
          fmt::format("{}: its ROI number {} is also another's, which gets the contours", name, number));
    set.rois.push_back({.name = std::move(name), .interpreted_type = {}, .color = {}, .contours = {}});
  }
  make_names_unique(set);
  return index_of;
}

void read_referenced_series(const gdcm::DataSet& data, RtStructureSet& set) {
  for (const gdcm::DataSet& frame : dicom_items(data, frames_of_reference))
    for (const gdcm::DataSet& study : dicom_items(frame, studies))
      for (const gdcm::DataSet& series : dicom_items(study, series_sequence))
        if (std::string uid = dicom_text(series, series_uid); !uid.empty()) set.series_uids.push_back(std::move(uid));
}

void read_contours_and_types(const gdcm::DataSet& data, const std::map<std::string, std::size_t>& index_of,
                             RtStructureSet& set) {
  for (const gdcm::DataSet& item : dicom_items(data, roi_contours)) {
    const auto roi = index_of.find(dicom_text(item, referenced_roi));
    if (roi == index_of.end()) {
      set.warnings.push_back("contours left out that belong to no ROI of the list");
      continue;
    }
    RtRoi& target = set.rois[roi->second];
    target.color = color_from(dicom_numbers(item, display_color));
    auto contours = contours_of(item, target.name, set);
    std::move(contours.begin(), contours.end(), std::back_inserter(target.contours));
  }
  for (const gdcm::DataSet& item : dicom_items(data, observations))
    if (const auto roi = index_of.find(dicom_text(item, referenced_roi)); roi != index_of.end())
      set.rois[roi->second].interpreted_type = dicom_text(item, interpreted_type);
}

}  // namespace

RtStructureSet read_rtstruct_file(const std::filesystem::path& path) {
  const DicomHeader header = read_dicom_header(path);
  if (header.kind != DicomKind::kStructureSet)
    throw InputError(path.string(), fmt::format("it is DICOM of modality {}, not a structure set", header.modality),
                     "give an RTSTRUCT file");
  DicomReader reader(path);
  // The walk over the file ended at pixel data, which no structure set has.
  const gdcm::Tag pixel_data(0x7fe0, 0x0010);
  if (!reader->ReadUpToTag(pixel_data)) throw_damaged(path, "the DICOM file is cut off or damaged");
  const gdcm::DataSet& data = reader->GetFile().GetDataSet();
  RtStructureSet set;
  const auto index_of = read_names(data, set);
  if (set.rois.empty()) throw_damaged(path, "the structure set has no list of ROIs (StructureSetROISequence)");
  read_referenced_series(data, set);
  read_contours_and_types(data, index_of, set);
  return set;
}

}  // namespace isostack
