#pragma once

#include <filesystem>

#include "io/volumes/stored_volume.h"
#include "io/write_options.h"
#include "recon/geometry/label_map.h"

namespace isostack {

/// NRRD, attached (.nrrd) or detached (.nhdr), raw or gzip, one 3D or 2D grey or label
/// volume. All "space" names of patient directions are turned into LPS.
/// Throws InputError naming the file.
VolumeHeader read_nrrd_header(const std::filesystem::path& path);
Volume<float> read_nrrd(const std::filesystem::path& path);
StoredVolume read_stored_nrrd(const std::filesystem::path& path);

/// Also several layers along a first axis without a direction, and names, colours, layers and values of segments as
/// 3D Slicer writes them (.seg.nrrd).
LabelMap read_nrrd_labels(const std::filesystem::path& path);

/// Writes LPS, every digit of the pose, gzip unless options.compressed is false; the voxels of a .nhdr go into a
/// neighbour named .raw.gz or .raw. The type stays; a rescale, which NRRD has not, is applied (with_rescale_applied).
/// Throws InputError naming the file when it cannot be written.
void write_nrrd(const StoredVolume& volume, const std::filesystem::path& path, const WriteOptions& options = {});

/// 8-bit labels where they suffice, else 16-bit, with the fields of 3D Slicer's .seg.nrrd, whatever the name.
void write_nrrd_labels(const LabelMap& labels, const std::filesystem::path& path, const WriteOptions& options = {});

}  // namespace isostack
