#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "recon/geometry/volume.h"

namespace isostack {

/// What a NIfTI, NRRD or MetaImage header says about its voxels.
struct VolumeHeader {
  Grid grid;               ///< index order of the file; world LPS mm
  std::string value_type;  ///< "int16", "float", ...
  int components = 1;      ///< values per voxel, interleaved: layers of labels
  double slope = 1;        ///< value = slope * stored + intercept
  double intercept = 0;
  bool is_distance = false;           ///< values are signed distances in mm, positive inside, and the file says so
  std::vector<std::string> warnings;  ///< what to know about the pose
};

/// What files say of such values: in `intent_name` of NIfTI, `Comment` of MetaImage, `content` of NRRD.
inline constexpr std::string_view distance_mark = "signed distance";

/// Where a header's voxels are.
struct VoxelFile {
  std::filesystem::path path;
  bool compressed = false;
  std::uintmax_t offset_bytes = 0;
  bool offset_is_inflated = false;  ///< the offset counts bytes after decompression
  bool swapped = false;             ///< byte order is not this machine's
};

/// Throws InputError naming `where` unless the grid has 1 to 65536 voxels along each axis, an
/// invertible pose, perpendicular i and j, and voxels that fit into the file: before anything of that size is
/// allocated.
void check_volume_header(const VolumeHeader& header, const VoxelFile& voxels, const std::string& where);

/// diag(-1, -1, 1) * ras: turns an index-to-RAS map into an index-to-LPS map.
Eigen::Affine3d lps_from_ras(const Eigen::Affine3d& ras);

}  // namespace isostack
