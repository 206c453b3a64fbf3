#include "io/dicom_series.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "io/dicom_pixels.h"
#include "io/slice_order.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

void require_equal_sizes(const std::vector<DicomHeader>& files) {
  const DicomHeader* first = &files.front();
  for (const DicomHeader& file : files) {
    if (file.series_uid != first->series_uid) first = &file;
    if (file.columns != first->columns || file.rows != first->rows)
      throw InputError(file.name,
                       fmt::format("the slice has {} x {} pixels, but {} has {} x {}", file.columns, file.rows,
                                   first->name, first->columns, first->rows),
                       "take the slices of other sizes out of the series");
  }
}

void require_distinct_places(const OrderedSeries& series) {
  constexpr double same_place_mm = 1e-3;
  for (std::size_t i = 1; i < series.poses.size(); ++i) {
    const SlicePose& previous = series.poses[i - 1];
    const SlicePose& pose = series.poses[i];
    if (are_parallel(previous, pose) && std::abs(previous.signed_distance_mm(pose.origin_mm)) < same_place_mm)
      throw GeometryError(series.files[i].name, "the slice lies at the same position as " + series.files[i - 1].name,
                          "keep one of the two (one time or echo of a series)");
  }
}

std::vector<std::string> names_of(const std::vector<DicomHeader>& files) {
  std::vector<std::string> names;
  names.reserve(files.size());
  for (const DicomHeader& file : files) names.push_back(file.name);
  return names;
}

std::vector<Slice> decode(const OrderedSeries& series, const Progress& progress) {
  const std::size_t count = series.files.size();
  std::vector<Slice> slices(count);
  constexpr std::size_t slices_per_report = 16;
  for (std::size_t begin = 0; begin < count; begin += slices_per_report) {
    progress.report("pixels", static_cast<double>(begin) / static_cast<double>(count));
    tbb::parallel_for(begin, std::min(count, begin + slices_per_report), [&](std::size_t i) {
      slices[i] = {series.files[i].name, series.poses[i], read_dicom_pixels(series.files[i])};
    });
  }
  progress.report("pixels", 1);
  return slices;
}

/// A folder may be full of segmentations or structure sets only; say so instead of "no image".
void require_images(const DicomScan& scan, const std::string& where) {
  if (!scan.damaged.empty())
    throw InputError(
        where, fmt::format("{} of its DICOM files cannot be read ({})", scan.damaged.size(), scan.damaged.front()),
        "repair or remove them");
  if (scan.series.empty())
    throw InputError(where, "there is no readable DICOM file in it", "give the folder that holds the slices");
  const bool has_images = scan.series.front().kind == DicomKind::kImage;
  if (!has_images)
    throw InputError(where,
                     fmt::format("it holds DICOM of modality {} but no image slices", scan.series.front().modality),
                     "give the folder of the images it belongs to");
}

}  // namespace

OrderedSeries order_series(const DicomSeries& series) {
  std::vector<SlicePose> poses;
  poses.reserve(series.files.size());
  for (const DicomHeader& file : series.files) {
    require_grey_single_frame(file);
    poses.push_back(pose_of(file));
  }
  require_equal_sizes(series.files);
  OrderedSeries ordered;
  for (const std::size_t i : order_along_normals(poses)) {
    ordered.files.push_back(series.files[i]);
    ordered.poses.push_back(poses[i]);
  }
  require_distinct_places(ordered);
  return ordered;
}

std::vector<std::string> series_warnings(const OrderedSeries& series) {
  const DicomHeader& first = series.files.front();
  auto warnings = geometry_warnings(analyse_stack(series.poses), names_of(series.files),
                                    {first.slice_thickness_mm, first.spacing_between_slices_mm});
  const auto inverted = std::count_if(series.files.begin(), series.files.end(),
                                      [](const DicomHeader& file) { return file.photometric == "MONOCHROME1"; });
  if (inverted > 0)
    warnings.push_back(
        fmt::format("inverted greys: {} slices are MONOCHROME1, where larger values are shown darker; "
                    "the values are kept as stored",
                    inverted));
  return warnings;
}

SliceStack read_dicom_slices(const std::filesystem::path& path, const ReadOptions& options, const Progress& progress) {
  const DicomScan scan = scan_dicom(path, progress);
  require_images(scan, path.string());
  const OrderedSeries series = order_series(select_series(scan, options.series, path.string()));
  SliceStack stack;
  const DicomHeader& first = series.files.front();
  stack.name =
      first.series_uid.empty() ? first.modality : fmt::format("{} ...{}", first.modality, uid_ending(first.series_uid));
  stack.warnings = series_warnings(series);
  stack.slices = decode(series, progress);
  return stack;
}

}  // namespace isostack
