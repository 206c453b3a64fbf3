#pragma once

#include <filesystem>

#include "io/volumes/stored_volume.h"
#include "io/write_options.h"
#include "recon/geometry/label_map.h"

namespace isostack {

/// MetaImage, .mha or .mhd with its voxels in one other file, plain or compressed, one 3D or 2D
/// grey or label volume. Its coordinates are LPS. Throws InputError naming the file.
VolumeHeader read_metaimage_header(const std::filesystem::path& path);
Volume<float> read_metaimage(const std::filesystem::path& path);
StoredVolume read_stored_metaimage(const std::filesystem::path& path);
LabelMap read_metaimage_labels(const std::filesystem::path& path);

/// Writes every digit of the pose, compressed by zlib unless options.compressed is false; the voxels of a .mhd go
/// into a neighbour named .zraw or .raw. The type stays; a rescale, which MetaImage has not, is applied
/// (with_rescale_applied). Throws InputError naming the file when it cannot be written.
void write_metaimage(const StoredVolume& volume, const std::filesystem::path& path, const WriteOptions& options = {});

/// 8-bit labels where they suffice, else 16-bit. MetaImage has no place for names and holds one layer: InputError
/// when there are more.
void write_metaimage_labels(const LabelMap& labels, const std::filesystem::path& path,
                            const WriteOptions& options = {});

}  // namespace isostack
