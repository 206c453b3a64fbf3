#pragma once

#include <cstdint>
#include <filesystem>

#include "io/volumes/volume_header.h"

namespace isostack {

/// A parsed NIfTI-1 or NIfTI-2 header.
struct NiftiHeader {
  VolumeHeader volume;
  VoxelFile voxels;
  std::uintmax_t extensions_begin = 0;  ///< bytes between the header and the voxels, after decompression
};

/// Reads .nii or .nii.gz. The pose is the sform if its code is positive, else the
/// qform, else the voxel size alone. Throws InputError naming the file.
NiftiHeader parse_nifti_header(const std::filesystem::path& path);

}  // namespace isostack
