#include "io/dicom/dicom_scan.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <map>

#include "io/file_listing.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

struct HeaderOrError {
  std::optional<DicomHeader> header;
  std::string error;
};

HeaderOrError read_if_dicom(const std::filesystem::path& path, bool is_chosen) {
  HeaderOrError result;
  if (access(path.c_str(), R_OK) != 0) {
    const std::error_code error(errno, std::generic_category());
    result.error = InputError(path.filename().string(), "the file cannot be opened (" + error.message() + ")",
                              "check that you may read it")
                       .what();
    return result;
  }
  if (!is_chosen && !looks_like_dicom(path)) return result;
  try {
    result.header = read_dicom_header(path);
  } catch (const Error& error) {
    result.error = error.what();
  }
  return result;
}

std::vector<HeaderOrError> read_headers(const std::vector<std::filesystem::path>& paths, const Progress& progress) {
  std::vector<HeaderOrError> results(paths.size());
  constexpr std::size_t files_per_report = 64;
  for (std::size_t begin = 0; begin < paths.size(); begin += files_per_report) {
    progress.report("headers", static_cast<double>(begin) / static_cast<double>(paths.size()));
    const std::size_t end = std::min(paths.size(), begin + files_per_report);
    tbb::parallel_for(begin, end, [&](std::size_t i) { results[i] = read_if_dicom(paths[i], paths.size() == 1); });
  }
  return results;
}

std::string list_series(const DicomScan& scan) {
  std::string list;
  for (std::size_t i = 0; i < scan.series.size(); ++i) {
    const DicomSeries& series = scan.series[i];
    if (series.kind != DicomKind::kImage) continue;
    const DicomHeader& first = series.files.front();
    list += fmt::format("{}{}: {}, {} slices of {} x {}, UID ...{}", list.empty() ? "" : "; ", i + 1, series.modality,
                        series.files.size(), first.columns, first.rows, uid_ending(series.uid));
  }
  return list;
}

DicomSeries all_images(const DicomScan& scan) {
  DicomSeries all;
  all.is_scene = true;
  all.kind = DicomKind::kImage;
  for (const DicomSeries& series : scan.series) {
    if (series.kind != DicomKind::kImage) continue;
    if (all.modality.empty()) all.modality = series.modality;
    all.files.insert(all.files.end(), series.files.begin(), series.files.end());
  }
  return all;
}

std::vector<const DicomSeries*> matching(const DicomScan& scan, const std::string& wanted) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  const bool is_number = error == std::errc() && end == wanted.data() + wanted.size();
  if (is_number && number >= 1 && number <= scan.series.size() && scan.series[number - 1].kind == DicomKind::kImage)
    return {&scan.series[number - 1]};
  std::vector<const DicomSeries*> found;
  for (const DicomSeries& series : scan.series)
    if (series.kind == DicomKind::kImage && series.uid.ends_with(wanted)) found.push_back(&series);
  return found;
}

/// Folder names may tell who the patient is, so files of one name are told apart by a number.
void number_equal_names(DicomScan& scan) {
  std::map<std::string, std::vector<DicomHeader*>> files_of;
  for (DicomSeries& series : scan.series)
    for (DicomHeader& file : series.files) files_of[file.name].push_back(&file);
  for (auto& [name, files] : files_of)
    for (std::size_t i = 0; files.size() > 1 && i < files.size(); ++i)
      files[i]->name = fmt::format("{} [{}]", name, i + 1);
}

}  // namespace

std::string uid_ending(const std::string& uid) { return uid.substr(uid.size() - std::min<std::size_t>(uid.size(), 8)); }

DicomScan scan_dicom(const std::filesystem::path& path, const Progress& progress) {
  require_exists(path);
  const bool is_folder = std::filesystem::is_directory(path);
  const auto paths = is_folder ? files_in(path, Depth::kAllBelow) : std::vector{path};
  DicomScan scan;
  std::map<std::pair<DicomKind, std::string>, std::size_t> index_of;
  for (HeaderOrError& result : read_headers(paths, progress)) {
    if (!result.error.empty()) scan.damaged.push_back(result.error);
    if (!result.header) continue;
    DicomHeader& header = *result.header;
    const auto [entry, is_new] = index_of.try_emplace({header.kind, header.series_uid}, scan.series.size());
    if (is_new) scan.series.push_back({header.series_uid, header.modality, header.kind, {}, false});
    scan.series[entry->second].files.push_back(std::move(header));
  }
  std::stable_sort(scan.series.begin(), scan.series.end(),
                   [](const DicomSeries& a, const DicomSeries& b) { return a.kind < b.kind; });
  number_equal_names(scan);
  return scan;
}

DicomSeries select_series(const DicomScan& scan, const std::string& wanted, const std::string& where) {
  const auto image_count = std::count_if(scan.series.begin(), scan.series.end(),
                                         [](const DicomSeries& s) { return s.kind == DicomKind::kImage; });
  if (image_count == 0)
    throw InputError(where, "there is no DICOM image in it", "give the folder that holds the slices");
  if (wanted == "all") return all_images(scan);
  const std::vector<const DicomSeries*> found = matching(scan, wanted);
  if (found.size() == 1) return *found.front();
  if (wanted.empty())
    throw InputError(where, fmt::format("it holds {} series ({})", image_count, list_series(scan)),
                     "choose one with --series NUMBER or UID, or take --series all as one scene");
  throw InputError(
      where, fmt::format("{} series match '{}' among {}", found.empty() ? "no" : "several", wanted, list_series(scan)),
      "choose one by its number with --series");
}

}  // namespace isostack
