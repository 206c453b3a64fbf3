#pragma once

#include <filesystem>

#include "io/volume_header.h"
#include "io/write_options.h"
#include "recon/geometry/label_map.h"

namespace isostack {

/// NIfTI-1 and -2, .nii and .nii.gz, one 3D or 2D volume. Index order is that of the file; RAS is
/// turned into LPS. Throws InputError naming the file.
VolumeHeader read_nifti_header(const std::filesystem::path& path);
Volume<float> read_nifti(const std::filesystem::path& path);

/// Writes NIfTI-1 with 16-bit labels, compressed if the name ends in .gz. The sform holds the
/// grid exactly; the qform too, except for a sheared grid, which it cannot express (its code is 0
/// then). Throws InputError naming the file, also when there is more than one layer.
void write_nifti_labels(const LabelMap& labels, const std::filesystem::path& path, const WriteOptions& options = {});

}  // namespace isostack
