#include "io/dicom/dicom_series.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/dicom/dicom_pixels.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

std::vector<std::string> names_of(const std::vector<DicomHeader>& files) {
  std::vector<std::string> names;
  names.reserve(files.size());
  for (const DicomHeader& file : files) names.push_back(file.name);
  return names;
}

/// What the pictures themselves, not their places, make a user doubt.
std::vector<std::string> picture_warnings(const std::vector<DicomHeader>& files) {
  std::vector<std::string> warnings;
  const auto count_if = [&](auto holds) { return std::count_if(files.begin(), files.end(), holds); };
  if (const auto inverted = count_if([](const DicomHeader& file) { return file.photometric == "MONOCHROME1"; }))
    warnings.push_back(
        fmt::format("inverted greys: {} slices are MONOCHROME1, where larger values are shown darker; "
                    "the values are kept as stored",
                    inverted));
  if (const auto lossy = count_if([](const DicomHeader& file) { return file.was_compressed_lossy; }))
    warnings.push_back(fmt::format("lossy compression: the grey values of {} slices are not exact", lossy));
  const auto moved = std::find_if(files.begin(), files.end(), [&](const DicomHeader& file) {
    return file.frame_of_reference_uid != files.front().frame_of_reference_uid;
  });
  if (moved != files.end())
    warnings.push_back(
        fmt::format("differing frames of reference: {} and {} do not share one, so they need not lie in one patient "
                    "position",
                    files.front().name, moved->name));
  return warnings;
}

/// Files of a folder that are left out because they cannot be read. Which series they belong to cannot be known.
std::vector<std::string> damage_warnings(const std::vector<std::string>& damaged) {
  constexpr std::size_t most = 5;
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < std::min(most, damaged.size()); ++i)
    warnings.push_back("damaged files: left out, so a slice may be missing: " + damaged[i]);
  if (damaged.size() > most)
    warnings.push_back(
        fmt::format("damaged files: {} more left out; `isostack info` lists them", damaged.size() - most));
  return warnings;
}

/// A folder may be full of segmentations or structure sets only; say so instead of "no image".
void require_images(const DicomScan& scan, const std::filesystem::path& path) {
  const std::string where = path.string();
  if (!scan.damaged.empty() && !std::filesystem::is_directory(path)) read_dicom_header(path);  // throws what is wrong
  const bool has_any_image = !scan.series.empty() && scan.series.front().kind == DicomKind::kImage;
  if (!scan.damaged.empty() && !has_any_image)
    throw InputError(
        where, fmt::format("{} of its DICOM files cannot be read ({})", scan.damaged.size(), scan.damaged.front()),
        "repair or remove them");
  if (scan.series.empty())
    throw InputError(where, "there is no readable DICOM file in it", "give the folder that holds the slices");
  const std::string& modality = scan.series.front().modality;
  if (!has_any_image)
    throw InputError(
        where, fmt::format("it holds DICOM{} but no image slices", modality.empty() ? "" : " of modality " + modality),
        "give the folder of the images it belongs to");
}

/// Takes the pictures without pixels out of both and returns why each has none; throws when none is left, or when
/// the file itself was asked for.
std::vector<std::string> leave_out_failures(bool is_folder, OrderedSeries& series, DicomPictures& pictures) {
  std::vector<std::string> reasons;
  const InputError* first = nullptr;
  for (const auto& failure : pictures.failures) {
    if (!failure) continue;
    if (!first) first = &*failure;
    reasons.emplace_back(failure->what());
  }
  if (first && (!is_folder || reasons.size() == series.files.size())) throw InputError(*first);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < series.files.size(); ++i) {
    if (pictures.failures[i]) continue;
    std::swap(series.files[kept], series.files[i]);
    std::swap(series.poses[kept], series.poses[i]);
    pictures.images[kept++].swap(pictures.images[i]);
  }
  series.files.resize(kept);
  series.poses.resize(kept);
  pictures.images.resize(kept);
  return reasons;
}

}  // namespace

std::vector<std::string> series_warnings(const OrderedSeries& series) {
  const DicomHeader& first = series.files.front();
  auto warnings = geometry_warnings(analyse_stack(series.poses), names_of(series.files),
                                    {first.slice_thickness_mm, first.spacing_between_slices_mm});
  warnings.insert(warnings.end(), series.remarks.begin(), series.remarks.end());
  if (series.files.size() < 3)
    warnings.push_back(
        fmt::format("few slices: {} say little about the shape between and beyond them", series.files.size()));
  for (std::string& warning : picture_warnings(series.files)) warnings.push_back(std::move(warning));
  return warnings;
}

SliceStack read_dicom_slices(const std::filesystem::path& path, const ReadOptions& options, const Progress& progress) {
  const DicomScan scan = scan_dicom(path, progress);
  require_images(scan, path);
  OrderedSeries series = order_series(select_series(scan, options.series, path.string()), options.phase);
  DicomPictures pictures = read_dicom_pictures(series.files, progress);
  std::vector<std::string> damaged = scan.damaged;
  for (std::string& reason : leave_out_failures(std::filesystem::is_directory(path), series, pictures))
    damaged.push_back(std::move(reason));
  SliceStack stack;
  const DicomHeader& first = series.files.front();
  stack.name =
      first.series_uid.empty() ? first.modality : fmt::format("{} ...{}", first.modality, uid_ending(first.series_uid));
  stack.warnings = damage_warnings(damaged);
  for (std::string& warning : series_warnings(series)) stack.warnings.push_back(std::move(warning));
  for (std::size_t i = 0; i < pictures.images.size(); ++i)
    stack.slices.push_back({series.files[i].name, series.poses[i], std::move(pictures.images[i])});
  return stack;
}

}  // namespace isostack
