#pragma once

#include <filesystem>

#include "io/volume_header.h"

namespace isostack {

/// NRRD, attached (.nrrd) or detached (.nhdr), raw or gzip, one 3D or 2D grey or label
/// volume. All "space" names of patient directions are turned into LPS.
/// Throws InputError naming the file.
VolumeHeader read_nrrd_header(const std::filesystem::path& path);
Volume<float> read_nrrd(const std::filesystem::path& path);

}  // namespace isostack
