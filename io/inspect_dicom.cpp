#include <fmt/format.h>

#include "io/dicom_series.h"
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
  if (series.kind != DicomKind::kImage) return summary;
  try {
    const OrderedSeries ordered = order_series(series);
    summarise_poses(ordered.poses, first.columns, first.rows, summary);
    summary.warnings = series_warnings(ordered);
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
