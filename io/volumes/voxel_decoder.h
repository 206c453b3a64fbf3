#pragma once

#include <string>
#include <vector>

#include "io/volumes/stored_volume.h"
#include "io/volumes/volume_header.h"

namespace isostack {

/// Reads the voxels that a header describes as floats, i fastest, with its rescale applied: plain
/// or compressed by deflate (gzip or zlib), in either byte order. Memory is taken only for what
/// check_volume_header has found possible. Throws InputError naming `where` when they are cut off or damaged.
///
/// VTK's readers are not used for this: they reverse slices depending on handedness, take a short
/// first axis of a NRRD file for components, and crash on 2D NRRD files.
std::vector<float> read_voxels(const VolumeHeader& header, const VoxelFile& file, const std::string& where);

/// The same as stored, in this machine's byte order, all components of each voxel together.
StoredVolume read_stored_voxels(const VolumeHeader& header, const VoxelFile& file, const std::string& where);

/// Bytes of one value of the type ("int8" ... "uint64", "float", "double"); 0 for other names.
int bytes_of_type(const std::string& value_type);

}  // namespace isostack
