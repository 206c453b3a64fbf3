#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/read_slices.h"

namespace isostack {

/// PNG, TIFF, JPEG and BMP files in the folder (not below it), in natural order of their names.
std::vector<std::filesystem::path> images_in(const std::filesystem::path& folder);

/// What an image file's header says.
struct ImageInfo {
  int columns = 0, rows = 0;
  std::string format;      ///< "png", "tiff", ...
  std::string value_type;  ///< "uint8", ...
};
/// Throws InputError naming the file when it cannot be read.
ImageInfo image_info(const std::filesystem::path& path);

/// Reads one grey image or a folder of them as parallel slices along world z, the first at the
/// origin; rows run along y. Integer pixels keep their values, 8 or 16 bit; floats too.
/// Throws InputError naming the file, and when options.spacing_mm is missing.
SliceStack read_image_stack(const std::filesystem::path& path, const ReadOptions& options, const Progress& progress);

}  // namespace isostack
