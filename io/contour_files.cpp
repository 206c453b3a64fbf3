#include "io/contour_files.h"

#include "io/file_listing.h"
#include "io/formats.h"

namespace isostack {

std::vector<ContourStack> read_contours(const std::filesystem::path& path) {
  require_exists(path);
  return format_for(path, &Format::read_contours, "contours").read_contours(path);
}

bool holds_contours(const std::filesystem::path& path) {
  require_exists(path);
  const Format* format = find_format(path, &Format::read_contours);
  return format && format->holds_contours(path);
}

void write_contours(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                    const WriteOptions& options) {
  format_for(path, &Format::write_contours, "contours").write_contours(organs, path, options);
}

}  // namespace isostack
