#include "io/contours/contour_files.h"

#include "io/dicom/dicom_header.h"
#include "io/dicom/rtstruct.h"
#include "io/file_listing.h"
#include "io/formats.h"

namespace isostack {

namespace {

bool is_dicom(const std::filesystem::path& path) {
  return std::filesystem::is_regular_file(path) && looks_like_dicom(path);
}

}  // namespace

ContourFile read_contour_file(const std::filesystem::path& path, const ReadOptions& options) {
  require_exists(path);
  if (is_dicom(path)) return read_rtstruct(path, options);
  return format_for(path, &Format::read_contours, "contours").read_contours(path, options);
}

std::vector<ContourStack> read_contours(const std::filesystem::path& path, const ReadOptions& options) {
  return read_contour_file(path, options).organs;
}

bool holds_contours(const std::filesystem::path& path) {
  require_exists(path);
  if (is_dicom(path)) return is_rtstruct(path);
  const Format* format = find_format(path, &Format::read_contours);
  return format && format->holds_contours(path);
}

bool is_contour_file(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  const Format* format = find_format(path, &Format::read_contours);
  const bool tells_by_content = is_dicom(path) || (format && format->read_slices);
  return tells_by_content ? is_rtstruct(path) : format != nullptr;
}

void write_contours(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                    const WriteOptions& options) {
  format_for(path, &Format::write_contours, "contours").write_contours(organs, path, options);
}

}  // namespace isostack
