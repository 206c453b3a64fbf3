#include "recon/geometry/volume.h"

#include <cmath>

#include "recon/geometry/errors.h"

namespace isostack {

double Grid::voxel_volume_mm3() const { return std::abs(index_to_world.linear().determinant()); }

SlicePose pose_of_plane(const Grid& grid, int k, const std::string& where) {
  const Eigen::Matrix3d axes_mm = grid.index_to_world.linear();
  SlicePose pose;
  pose.spacing_mm = {axes_mm.col(0).norm(), axes_mm.col(1).norm()};
  pose.origin_mm = grid.index_to_world * Eigen::Vector3d(0, 0, k);
  pose.x_axis = axes_mm.col(0) / pose.spacing_mm.x();
  pose.y_axis = axes_mm.col(1) / pose.spacing_mm.y();
  return checked_pose(pose, where);
}

std::vector<Slice> slices_of(const Volume<float>& volume, const std::string& name) {
  const Grid& grid = volume.grid;
  std::vector<Slice> slices(static_cast<std::size_t>(grid.size.z()));
  for (int k = 0; k < grid.size.z(); ++k) {
    Slice& slice = slices[static_cast<std::size_t>(k)];
    slice.name = name + " slice " + std::to_string(k);
    slice.pose = pose_of_plane(grid, k, slice.name);
    slice.pixels = Eigen::Map<const Image<float>>(&volume.at(0, 0, k), grid.size.y(), grid.size.x());
  }
  return slices;
}

namespace {

void require_same_raster(const Slice& first, const Slice& other) {
  const bool same = first.pixels.rows() == other.pixels.rows() && first.pixels.cols() == other.pixels.cols() &&
                    (first.pose.spacing_mm - other.pose.spacing_mm).norm() < 1e-4 &&
                    (first.pose.x_axis - other.pose.x_axis).norm() < 1e-3 &&
                    (first.pose.y_axis - other.pose.y_axis).norm() < 1e-3;
  if (!same)
    throw GeometryError(other.name, "its size, spacing or orientation differs from that of " + first.name,
                        "use a stack of equal parallel slices as the grid");
}

}  // namespace

Grid grid_of(const SliceStack& stack) {
  if (stack.slices.size() < 2)
    throw GeometryError(stack.name, "fewer than two slices do not make a grid", "give a whole series or a volume");
  const Slice& first = stack.slices.front();
  const Eigen::Vector3d step_mm =
      (stack.slices.back().pose.origin_mm - first.pose.origin_mm) / static_cast<double>(stack.slices.size() - 1);
  for (std::size_t k = 0; k < stack.slices.size(); ++k) {
    const Slice& slice = stack.slices[k];
    require_same_raster(first, slice);
    const Eigen::Vector3d expected_mm = first.pose.origin_mm + static_cast<double>(k) * step_mm;
    if ((slice.pose.origin_mm - expected_mm).norm() > 0.01)
      throw GeometryError(slice.name, "the slices are not evenly spaced", "give a reference volume with an even grid");
  }
  if (std::abs(step_mm.dot(first.pose.normal())) < 0.01)
    throw GeometryError(stack.name, "its slices lie in one plane", "give slices at different positions");
  Grid grid;
  grid.size = {static_cast<int>(first.pixels.cols()), static_cast<int>(first.pixels.rows()),
               static_cast<int>(stack.slices.size())};
  grid.index_to_world.translation() = first.pose.origin_mm;
  grid.index_to_world.linear() << first.pose.x_axis * first.pose.spacing_mm.x(),
      first.pose.y_axis * first.pose.spacing_mm.y(), step_mm;
  return grid;
}

}  // namespace isostack
