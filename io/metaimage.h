#pragma once

#include <filesystem>

#include "io/volume_header.h"

namespace isostack {

/// MetaImage, .mha or .mhd with its voxels in one other file, plain or compressed, one 3D or 2D
/// grey or label volume. Its coordinates are LPS. Throws InputError naming the file.
VolumeHeader read_metaimage_header(const std::filesystem::path& path);
Volume<float> read_metaimage(const std::filesystem::path& path);

}  // namespace isostack
