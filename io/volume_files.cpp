#include "io/volume_files.h"

#include "io/file_listing.h"
#include "io/formats.h"

namespace isostack {

Volume<float> read_volume(const std::filesystem::path& path) {
  require_exists(path);
  return format_for(path, &Format::read_volume, "a volume").read_volume(path);
}

Grid read_grid(const std::filesystem::path& path, const ReadOptions& options) {
  require_exists(path);
  if (const Format* format = find_format(path, &Format::read_volume_header))
    return format->read_volume_header(path).grid;
  return grid_of(read_slices(path, options));
}

void write_labels(const LabelMap& labels, const std::filesystem::path& path, const WriteOptions& options) {
  format_for(path, &Format::write_labels, "a label volume").write_labels(labels, path, options);
}

}  // namespace isostack
