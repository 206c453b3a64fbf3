#include "cli/convert_inputs.h"

#include <algorithm>

#include "cli/label_inputs.h"
#include "io/contours/contour_files.h"
#include "io/dicom/dicom_header.h"
#include "io/file_listing.h"
#include "io/formats.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

/// .seg.nrrd and DICOM SEG.
bool holds_labels_only(const std::filesystem::path& output) {
  return output.filename().string().ends_with(".seg.nrrd") || !find_format(output, &Format::write_volume);
}

/// As readers call a value that has no name of its own.
bool is_number(const std::string& name) {
  return !name.empty() && name.find_first_not_of("-0123456789") == std::string::npos;
}

/// True of NIfTI and NRRD files that say what their numbers mean.
bool names_organs(const std::filesystem::path& path) {
  const Format* format = find_format(path, &Format::read_volume_header);
  if (!format || !format->read_labels) return false;
  const std::string type = format->read_volume_header(path).value_type;
  if (type == "float" || type == "double") return false;
  try {
    const std::vector<Segment> segments = read_labels(path).segments;
    return std::any_of(segments.begin(), segments.end(),
                       [](const Segment& segment) { return !is_number(segment.name); });
  } catch (const InputError&) {
    return false;  // grey values
  }
}

}  // namespace

const char* name_of(InputKind kind) {
  switch (kind) {
    case InputKind::kContours:
      return "contours";
    case InputKind::kMesh:
      return "mesh";
    case InputKind::kLabels:
      return "labels";
    default:
      return "volume";
  }
}

InputKind kind_of(const std::filesystem::path& input, const std::filesystem::path& output) {
  require_exists(input);
  if (std::filesystem::is_directory(input)) return InputKind::kVolume;
  if (is_contour_file(input) && (holds_contours(input) || !find_format(input, &Format::read_mesh)))
    return InputKind::kContours;
  if (find_format(input, &Format::read_mesh)) return InputKind::kMesh;
  const bool can_be_labels = may_hold_labels(input) && find_format(output, &Format::write_labels);
  if (holds_named_organs(input)) return InputKind::kLabels;
  if (can_be_labels && (holds_labels_only(output) || names_organs(input))) return InputKind::kLabels;
  if (looks_like_dicom(input) || find_format(input, &Format::read_slices) || find_format(input, &Format::read_volume))
    return InputKind::kVolume;
  format_for(input, &Format::read_mesh, "a file to convert");  // throws
  return InputKind::kMesh;
}

StoredVolume read_as_volume(const InputOptions& input, Session& session) {
  const std::filesystem::path& path = input.paths.front();
  if (std::filesystem::is_regular_file(path) && !looks_like_dicom(path) &&
      find_format(path, &Format::read_stored_volume))
    return read_stored_volume(path);
  const SliceStack stack = read_images(input, session);
  Volume<float> volume(grid_of(stack));
  auto voxel = volume.voxels.begin();
  for (const Slice& slice : stack.slices)
    voxel = std::copy(slice.pixels.data(), slice.pixels.data() + slice.pixels.size(), voxel);
  return stored_volume_of(volume);
}

}  // namespace isostack::cli
