#pragma once

#include "io/read_slices.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/volume.h"
#include "tests/io/io_support.h"

namespace isostack::testing {

/// A lattice of 4 x 3 x 5 voxels that is rotated and has three different spacings.
inline Grid oblique_grid(bool left_handed = false) {
  const SlicePose pose = oblique_pose();
  Grid grid;
  grid.size = {4, 3, 5};
  grid.index_to_world.linear() << pose.x_axis * pose.spacing_mm.x(), pose.y_axis * pose.spacing_mm.y(),
      pose.normal() * (left_handed ? -2.5 : 2.5);
  grid.index_to_world.translation() = pose.origin_mm;
  return grid;
}

/// 1, 2, 3, ... in the order of the file.
template <class T>
std::vector<T> counted(const Grid& grid) {
  std::vector<T> voxels(grid.voxel_count());
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<T>(i + 1);
  return voxels;
}

template <class T>
std::string as_bytes(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

inline void expect_same_grid(const Grid& a, const Grid& b, double tolerance_mm) {
  EXPECT_EQ(a.size, b.size);
  EXPECT_LT((a.index_to_world.matrix() - b.index_to_world.matrix()).cwiseAbs().maxCoeff(), tolerance_mm);
}

/// Every proper beginning of the file must give an Error, never a crash or a volume.
inline void expect_truncations_noticed(const std::filesystem::path& path) {
  const std::string whole = bytes_of(path);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write_bytes(path, whole.substr(0, length));
    EXPECT_THROW(read_volume(path), Error) << length << " of " << whole.size() << " bytes";
  }
  write_bytes(path, whole);
}

}  // namespace isostack::testing
