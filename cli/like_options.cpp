#include "cli/like_options.h"

#include <algorithm>

#include "cli/path_roles.h"
#include "io/contours/contour_files.h"
#include "io/dicom/dicom_header.h"
#include "io/dicom/dicom_seg.h"
#include "io/file_listing.h"

namespace isostack::cli {

namespace {

bool is_dicom_images(const std::filesystem::path& path) {
  if (std::filesystem::is_regular_file(path))
    return looks_like_dicom(path) && !is_contour_file(path) && !is_dicom_seg(path);
  if (!std::filesystem::is_directory(path)) return false;
  const auto files = files_in(path, Depth::kAllBelow);
  return std::any_of(files.begin(), files.end(), looks_like_dicom);
}

}  // namespace

void add_like_options(CLI::App& command, LikeOptions& options) {
  command
      .add_option("--like", options.series,
                  "DICOM output: the image series that it refers to (default: the input, when that is one)")
      ->check(read_path());
  command.add_option("--like-series", options.series_choice, "Which series of --like, as --series");
  command.add_flag("--identify", options.identify, "DICOM output: copy patient and study from that series");
}

WriteOptions write_options_for(const LikeOptions& options, const InputOptions& input) {
  WriteOptions result;
  result.identify = options.identify;
  result.like_series = options.series_choice;
  if (!options.series.empty()) {
    result.like = options.series;
    return result;
  }
  const auto images = std::find_if(input.paths.begin(), input.paths.end(), is_dicom_images);
  if (images != input.paths.end())
    result.like = *images;
  else if (!input.images.empty())
    result.like = input.images;
  if (result.like_series.empty()) result.like_series = input.series;
  return result;
}

}  // namespace isostack::cli
