#pragma once

#include <filesystem>

#include "io/volumes/stored_volume.h"
#include "io/write_options.h"
#include "recon/geometry/label_map.h"

namespace isostack {

/// NIfTI-1 and -2, .nii and .nii.gz, one 3D or 2D volume. Index order is that of the file; RAS is
/// turned into LPS. Throws InputError naming the file.
VolumeHeader read_nifti_header(const std::filesystem::path& path);
Volume<float> read_nifti(const std::filesystem::path& path);
StoredVolume read_stored_nifti(const std::filesystem::path& path);

/// Names and colours come from a label table in the header's extension (read_nifti_label_names).
LabelMap read_nifti_labels(const std::filesystem::path& path);

/// Writes NIfTI-1, compressed if the name ends in .gz. Stored type and rescale stay as they are, except for a
/// rescale that single precision does not hold: then with_rescale_applied. The sform holds the grid exactly; the qform
/// too, except for a sheared grid, which it cannot express (its code is 0 then). Throws InputError naming the file.
void write_nifti(const StoredVolume& volume, const std::filesystem::path& path, const WriteOptions& options = {});

/// The same with 16-bit labels, and the segments' names and colours in an extension (nifti_label_extension) if there
/// are any. Throws InputError naming the file, also when there is more than one layer.
void write_nifti_labels(const LabelMap& labels, const std::filesystem::path& path, const WriteOptions& options = {});

}  // namespace isostack
