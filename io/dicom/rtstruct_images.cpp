#include "io/dicom/rtstruct_images.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>

#include "io/dicom/dicom_header.h"
#include "io/dicom/dicom_scan.h"
#include "io/file_listing.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

bool names(const std::vector<std::string>& series_uids, const DicomHeader& header) {
  return header.kind == DicomKind::kImage &&
         std::find(series_uids.begin(), series_uids.end(), header.series_uid) != series_uids.end();
}

/// What else lies in the folder is none of our business, so what cannot be read is passed over.
std::vector<DicomHeader> images_beside(const std::filesystem::path& file, const std::vector<std::string>& series_uids) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const auto paths = files_in(folder, Depth::kThisFolder);
  std::vector<std::optional<DicomHeader>> headers(paths.size());
  tbb::parallel_for(std::size_t{0}, paths.size(), [&](std::size_t i) {
    try {
      if (looks_like_dicom(paths[i])) headers[i] = read_dicom_header(paths[i]);
    } catch (const Error&) {
      headers[i].reset();
    }
  });
  std::vector<DicomHeader> images;
  for (const auto& header : headers)
    if (header && names(series_uids, *header)) images.push_back(*header);
  return images;
}

std::vector<DicomHeader> images_in_series(const std::filesystem::path& path,
                                          const std::vector<std::string>& series_uids, const ReadOptions& options,
                                          std::string& warning) {
  const DicomScan scan = scan_dicom(path);
  std::vector<DicomHeader> images;
  for (const DicomSeries& series : scan.series)
    for (const DicomHeader& file : series.files)
      if (names(series_uids, file)) images.push_back(file);
  if (!images.empty()) return images;
  images = select_series(scan, options.series, path.string()).files;
  warning = "the given images are not those that the structure set names";
  return images;
}

}  // namespace

RtImages find_rt_images(const std::filesystem::path& structure_set, const std::vector<std::string>& series_uids,
                        const ReadOptions& options) {
  RtImages found;
  const std::vector<DicomHeader> files = options.images
                                             ? images_in_series(*options.images, series_uids, options, found.warning)
                                             : images_beside(structure_set, series_uids);
  for (const DicomHeader& file : files) {
    try {
      for (const DicomHeader& frame : frames_of(file))
        found.slices.push_back(
            {.name = frame.name, .pose = pose_of(frame), .size_pixels = {frame.columns, frame.rows}, .contours = {}});
    } catch (const Error& error) {
      found.warning = error.what();
    }
  }
  if (found.slices.empty() && found.warning.empty())
    found.warning =
        "the images it was drawn on are not in its folder, so their extent is unknown and pixels are taken as 1 mm; "
        "tell where they are with --images";
  return found;
}

}  // namespace isostack
