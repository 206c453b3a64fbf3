#pragma once

#include <filesystem>

#include "io/read_slices.h"
#include "io/write_options.h"
#include "recon/geometry/label_map.h"

namespace isostack {

/// Reads NIfTI, NRRD or MetaImage with its pose from the header. Throws InputError naming the file.
Volume<float> read_volume(const std::filesystem::path& path);

/// The grid of a volume file or of an evenly spaced series.
Grid read_grid(const std::filesystem::path& path, const ReadOptions& options = {});

/// Writes labels as NIfTI (.nii, .nii.gz) with sform and qform. Whole file or none.
void write_labels(const LabelMap& labels, const std::filesystem::path& path, const WriteOptions& options = {});

}  // namespace isostack
