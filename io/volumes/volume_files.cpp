#include "io/volumes/volume_files.h"

#include "io/dicom/dicom_seg.h"
#include "io/file_listing.h"
#include "io/formats.h"

namespace isostack {

Volume<float> read_volume(const std::filesystem::path& path) {
  require_exists(path);
  return format_for(path, &Format::read_volume, "a volume").read_volume(path);
}

Grid read_grid(const std::filesystem::path& path, const ReadOptions& options) {
  require_exists(path);
  if (is_dicom_seg(path)) return read_dicom_seg_grid(path);
  if (const Format* format = find_format(path, &Format::read_volume_header))
    return format->read_volume_header(path).grid;
  return grid_of(read_slices(path, options));
}

StoredVolume read_stored_volume(const std::filesystem::path& path) {
  require_exists(path);
  return format_for(path, &Format::read_stored_volume, "a volume").read_stored_volume(path);
}

void write_volume(const StoredVolume& volume, const std::filesystem::path& path, const WriteOptions& options) {
  format_for(path, &Format::write_volume, "a volume").write_volume(volume, path, options);
}

namespace {

/// Null when the file cannot hold labels.
const Format* label_format(const std::filesystem::path& path) {
  if (is_dicom_seg(path)) return find_format("x.dcm", &Format::read_labels);  // often without an extension
  const Format* format = find_format(path, &Format::read_labels);
  return format && (!format->holds_labels || format->holds_labels(path)) ? format : nullptr;
}

}  // namespace

bool may_hold_labels(const std::filesystem::path& path) {
  return std::filesystem::is_regular_file(path) && label_format(path) != nullptr;
}

LabelMap read_labels(const std::filesystem::path& path) {
  require_exists(path);
  const Format* format = label_format(path);
  return (format ? *format : format_for(path, &Format::read_labels, "labels")).read_labels(path);
}

std::vector<LabelMap> read_label_planes(const std::filesystem::path& path) {
  require_exists(path);
  const Format* format = label_format(path);
  if (format && format->read_label_planes) return format->read_label_planes(path);
  return {read_labels(path)};
}

void write_labels(const LabelMap& labels, const std::filesystem::path& path, const WriteOptions& options) {
  format_for(path, &Format::write_labels, "a label volume").write_labels(labels, path, options);
}

}  // namespace isostack
