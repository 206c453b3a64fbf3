#include "io/volumes/volume_header.h"

#include <fmt/format.h>

#include "io/volumes/voxel_decoder.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

// deflate cannot shrink data by more than 1032:1.
constexpr double most_compression = 1032;

void check_sizes(const VolumeHeader& header, const VoxelFile& voxels, const std::string& where) {
  const Eigen::Vector3i size = header.grid.size;
  if (size.minCoeff() < 1 || size.maxCoeff() > 65536)
    throw InputError(where, fmt::format("the header claims {} x {} x {} voxels", size.x(), size.y(), size.z()),
                     "repair the header; 1 to 65536 voxels per axis are supported");
  std::error_code missing;
  const auto file_bytes = static_cast<double>(std::filesystem::file_size(voxels.path, missing));
  if (missing)
    throw InputError(where, "the voxel file " + voxels.path.filename().string() + " is missing",
                     "put it beside the header");
  const double claimed =
      static_cast<double>(header.grid.voxel_count()) * bytes_of_type(header.value_type) * header.components;
  const double possible =
      voxels.compressed ? file_bytes * most_compression : file_bytes - static_cast<double>(voxels.offset_bytes);
  if (claimed > possible)
    throw InputError(
        where,
        fmt::format("the header claims {:.0f} bytes of voxels and the file has {:.0f} bytes", claimed, file_bytes),
        "it is truncated or its header is wrong; copy it again");
}

}  // namespace

void check_volume_header(const VolumeHeader& header, const VoxelFile& voxels, const std::string& where) {
  check_sizes(header, voxels, where);
  const Eigen::Matrix3d axes_mm = header.grid.index_to_world.linear();
  pose_of_plane(header.grid, 0, where);
  const Eigen::Vector3d normal = axes_mm.col(0).cross(axes_mm.col(1)).normalized();
  const double gap_mm = std::abs(axes_mm.col(2).dot(normal));
  if (!axes_mm.allFinite() || (header.grid.size.z() > 1 && gap_mm < 1e-6))
    throw InputError(where, "the header puts all slices into one plane", "repair the pose in the header");
}

Eigen::Affine3d lps_from_ras(const Eigen::Affine3d& ras) {
  Eigen::Affine3d lps = ras;
  lps.prescale(Eigen::Vector3d(-1, -1, 1));
  return lps;
}

}  // namespace isostack
