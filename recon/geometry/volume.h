#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/geometry/slice.h"

namespace isostack {

/// A regular lattice of voxel centres; index (i, j, k) maps to world LPS mm. The map may be
/// sheared along k (gantry tilt); i and j are perpendicular.
struct Grid {
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  Eigen::Affine3d index_to_world = Eigen::Affine3d::Identity();

  std::size_t voxel_count() const {
    return static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(size.z());
  }
  std::size_t offset(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size.y()) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size.x()) +
           static_cast<std::size_t>(i);
  }
  double voxel_volume_mm3() const;
};

/// Values on a grid, i fastest.
template <class T>
struct Volume {
  Grid grid;
  std::vector<T> voxels;

  Volume() = default;
  explicit Volume(const Grid& on, T value = T()) : grid(on), voxels(on.voxel_count(), value) {}
  T& at(int i, int j, int k) { return voxels[grid.offset(i, j, k)]; }
  const T& at(int i, int j, int k) const { return voxels[grid.offset(i, j, k)]; }
};

using LabelVolume = Volume<std::uint16_t>;

/// Pose of the k-th k-plane of the grid. Throws GeometryError (naming `where`) on skewed axes.
SlicePose pose_of_plane(const Grid& grid, int k, const std::string& where);

/// The k-planes of a volume as slices named "<name> slice <k>".
std::vector<Slice> slices_of(const Volume<float>& volume, const std::string& name);

/// The grid whose k-planes are these slices. Throws GeometryError unless they are parallel, of
/// one size and spacing, and evenly spaced along one straight line out of their plane (within 0.01 mm).
Grid grid_of(const SliceStack& stack);

}  // namespace isostack
