#include <fmt/format.h>

#include "io/dicom/dicom_series.h"
#include "io/inspect_parts.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

const char* kind_name(DicomKind kind) {
  switch (kind) {
    case DicomKind::kImage:
      return "DICOM";
    case DicomKind::kSegmentation:
      return "DICOM SEG";
    case DicomKind::kStructureSet:
      return "DICOM RTSTRUCT";
    default:
      return "DICOM other";
  }
}

std::string repeated_positions(const OrderedSeries& series) {
  return fmt::format(
      "repeated positions: up to {} slices lie at one place, told apart by {}; choose one phase with "
      "--phase (phase 1 is shown)",
      series.phase_count, series.phases_by);
}

SeriesSummary summarise(const DicomSeries& series, int number) {
  const DicomHeader& first = series.files.front();
  SeriesSummary summary;
  summary.number = number;
  summary.kind = kind_name(series.kind);
  summary.modality = series.modality;
  summary.series_uid = series.uid;
  summary.encoding = first.transfer_syntax;
  summary.slice_count = series.files.size();
  summary.columns = first.columns;
  summary.rows = first.rows;
  if (first.bits_stored > 0) summary.value_type = fmt::format("{}int{}", first.is_signed ? "" : "u", first.bits_stored);
  if (series.kind == DicomKind::kStructureSet)
    for (const DicomHeader& file : series.files) summarise_structure_set(file.path, summary);
  if (series.kind == DicomKind::kSegmentation)
    for (const DicomHeader& file : series.files) summarise_segmentation(file.path, summary);
  if (series.kind != DicomKind::kImage) return summary;
  try {
    const OrderedSeries ordered = order_series(series, 1);
    summarise_poses(ordered.poses, ordered.files.front().columns, ordered.files.front().rows, summary);
    summary.phase_count = ordered.phase_count;
    summary.phases_by = ordered.phases_by;
    summary.slice_thickness_mm = ordered.files.front().slice_thickness_mm;
    summary.warnings = series_warnings(ordered);
    if (ordered.phase_count > 1) summary.warnings.insert(summary.warnings.begin(), repeated_positions(ordered));
  } catch (const Error& error) {
    summary.warnings.push_back(fmt::format("unusable: {}", error.what()));
  }
  return summary;
}

}  // namespace

std::vector<SeriesSummary> inspect_dicom(const std::filesystem::path& path) {
  const DicomScan scan = scan_dicom(path);
  std::vector<SeriesSummary> summaries;
  for (std::size_t i = 0; i < scan.series.size(); ++i)
    summaries.push_back(summarise(scan.series[i], static_cast<int>(i) + 1));
  if (!scan.damaged.empty()) {
    SeriesSummary& damaged = summaries.emplace_back();
    damaged.kind = "DICOM damaged";
    damaged.slice_count = scan.damaged.size();
    damaged.warnings = scan.damaged;
  }
  return summaries;
}

}  // namespace isostack
