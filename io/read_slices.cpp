#include "io/read_slices.h"

#include <algorithm>

#include "io/dicom/dicom_series.h"
#include "io/file_listing.h"
#include "io/formats.h"
#include "io/images/image_stack.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

SliceStack read_folder(const std::filesystem::path& folder, const ReadOptions& options, const Progress& progress) {
  const auto files = files_in(folder, Depth::kAllBelow);
  if (std::any_of(files.begin(), files.end(), looks_like_dicom)) return read_dicom_slices(folder, options, progress);
  if (!images_in(folder).empty()) return read_image_stack(folder, options, progress);
  throw InputError(folder.string(), files.empty() ? "the folder is empty" : "the folder holds no readable image",
                   "give a folder of DICOM slices or of PNG/TIFF images, or a volume file itself");
}

SliceStack read_as_slices(const Format& format, const std::filesystem::path& path) {
  SliceStack stack;
  stack.name = path.filename().string();
  stack.warnings = format.read_volume_header(path).warnings;
  const Volume<float> volume = format.read_volume(path);
  stack.slices = slices_of(volume, stack.name);
  return stack;
}

std::vector<std::string_view> slice_extensions() {
  auto extensions = extensions_with(&Format::read_slices);
  const auto volumes = extensions_with(&Format::read_volume);
  extensions.insert(extensions.end(), volumes.begin(), volumes.end());
  return extensions;
}

}  // namespace

SliceStack read_slices(const std::filesystem::path& path, const ReadOptions& options, const Progress& progress) {
  require_exists(path);
  if (std::filesystem::is_directory(path)) return read_folder(path, options, progress);
  if (looks_like_dicom(path)) return read_dicom_slices(path, options, progress);  // often without an extension
  if (const Format* format = find_format(path, &Format::read_volume)) return read_as_slices(*format, path);
  if (const Format* format = find_format(path, &Format::read_slices))
    return format->read_slices(path, options, progress);
  throw_unknown_extension(path, "slices", slice_extensions());
}

}  // namespace isostack
