#include "segmentation/keep_connected.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>

#include "segmentation/fast_marching.h"
#include "segmentation/field.h"

namespace isostack {

namespace {

/// A stack of planes as one array of voxels, plane by plane, row by row.
struct VoxelStack {
  std::int64_t planes, rows, columns;

  std::int64_t size() const { return planes * rows * columns; }
  std::int64_t voxel(const SeedPixel& at) const {
    return (static_cast<std::int64_t>(at.slice) * rows + at.row) * columns + at.column;
  }
  /// Calls visit(neighbour, axis) for the 6-neighbours; axis 0: columns, 1: rows, 2: planes.
  template <class Visit>
  void for_each_neighbour(std::int64_t voxel, Visit visit) const {
    const std::array<std::int64_t, 3> count = {columns, rows, planes}, stride = {1, columns, columns * rows};
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t position = voxel / stride[axis] % count[axis];
      if (position > 0) visit(voxel - stride[axis], axis);
      if (position + 1 < count[axis]) visit(voxel + stride[axis], axis);
    }
  }
};

std::uint8_t& at(std::vector<Mask>& planes, const VoxelStack& lattice, std::int64_t voxel) {
  const std::int64_t area = lattice.rows * lattice.columns;
  return planes[static_cast<std::size_t>(voxel / area)].data()[voxel % area];
}

void keep_reached(std::vector<Mask>& planes, const VoxelStack& lattice, const std::vector<SeedPixel>& seeds) {
  constexpr std::uint8_t organ = 1, reached = 2;
  std::vector<std::int64_t> pending;
  const auto visit = [&](std::int64_t voxel) {
    std::uint8_t& value = at(planes, lattice, voxel);
    if (value != organ) return;
    value = reached;
    pending.push_back(voxel);
  };
  for (const SeedPixel& seed : seeds) visit(lattice.voxel(seed));
  while (!pending.empty()) {
    const std::int64_t voxel = pending.back();
    pending.pop_back();
    lattice.for_each_neighbour(voxel, [&](std::int64_t next, int) { visit(next); });
  }
  for (Mask& mask : planes) mask = (mask == reached).cast<std::uint8_t>().eval();
}

bool any_shared(const std::vector<std::vector<Mask>>& organs) {
  for (std::size_t plane = 0; plane < organs.front().size(); ++plane) {
    Image<int> count = Image<int>::Zero(organs[0][plane].rows(), organs[0][plane].cols());
    for (const auto& organ : organs) count += organ[plane].cast<int>();
    if (count.maxCoeff() > 1) return true;
  }
  return false;
}

/// Time per mm at every voxel that any organ reaches.
std::vector<float> slowness(const std::vector<std::vector<Mask>>& organs, const Eigen::Vector2d& spacing_mm) {
  std::vector<float> result;
  const double pixel_mm = spacing_mm.minCoeff();
  for (std::size_t plane = 0; plane < organs.front().size(); ++plane) {
    Mask any = organs[0][plane];
    for (const auto& organ : organs) any = any.max(organ[plane]);
    Field<2> depth = field_of(any.cast<float>() - 0.5f, spacing_mm);
    redistance(depth, 1000 * pixel_mm);
    for (const float depth_mm : depth.values) {
      const double pixels = std::max(0.5, static_cast<double>(depth_mm) / pixel_mm);
      result.push_back(static_cast<float>(1 / (pixels * pixels)));
    }
  }
  return result;
}

struct Arrival {
  double time;
  std::int64_t voxel;
  std::size_t organ;
  bool operator>(const Arrival& other) const {
    return time != other.time ? time > other.time : voxel != other.voxel ? voxel > other.voxel : organ > other.organ;
  }
};

/// Dijkstra's shortest paths from all organs' seeds at once, every organ within its own mask.
void share_by_arrival(std::vector<std::vector<Mask>>& organs, const std::vector<std::vector<SeedPixel>>& seeds,
                      const VoxelStack& lattice, const std::vector<double>& positions_mm,
                      const Eigen::Vector2d& spacing_mm) {
  const std::vector<float> slow = slowness(organs, spacing_mm);
  std::vector<std::uint16_t> owner(static_cast<std::size_t>(lattice.size()), 0);
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> front;
  for (std::size_t organ = 0; organ < organs.size(); ++organ)
    for (const SeedPixel& seed : seeds[organ])
      if (at(organs[organ], lattice, lattice.voxel(seed))) front.push({0, lattice.voxel(seed), organ});
  const auto length_mm = [&](std::int64_t from, std::int64_t to, int axis) {
    if (axis < 2) return spacing_mm[axis];
    const std::int64_t area = lattice.rows * lattice.columns;
    return std::abs(positions_mm[static_cast<std::size_t>(to / area)] -
                    positions_mm[static_cast<std::size_t>(from / area)]);
  };
  while (!front.empty()) {
    const Arrival here = front.top();
    front.pop();
    std::uint16_t& mine = owner[static_cast<std::size_t>(here.voxel)];
    if (mine != 0) continue;
    mine = static_cast<std::uint16_t>(here.organ + 1);
    lattice.for_each_neighbour(here.voxel, [&](std::int64_t next, int axis) {
      if (owner[static_cast<std::size_t>(next)] != 0 || !at(organs[here.organ], lattice, next)) return;
      const float mean = (slow[static_cast<std::size_t>(here.voxel)] + slow[static_cast<std::size_t>(next)]) / 2;
      front.push({here.time + length_mm(here.voxel, next, axis) * mean, next, here.organ});
    });
  }
  for (std::size_t organ = 0; organ < organs.size(); ++organ)
    for (std::int64_t voxel = 0; voxel < lattice.size(); ++voxel)
      at(organs[organ], lattice, voxel) = owner[static_cast<std::size_t>(voxel)] == organ + 1;
}

}  // namespace

void keep_connected(std::vector<std::vector<Mask>>& organs, const std::vector<std::vector<SeedPixel>>& seeds,
                    const std::vector<double>& positions_mm, const Eigen::Vector2d& spacing_mm) {
  if (organs.empty() || organs.front().empty()) return;
  const Mask& first = organs.front().front();
  const VoxelStack lattice{static_cast<std::int64_t>(organs.front().size()), first.rows(), first.cols()};
  for (std::size_t organ = 0; organ < organs.size(); ++organ) keep_reached(organs[organ], lattice, seeds[organ]);
  if (any_shared(organs)) share_by_arrival(organs, seeds, lattice, positions_mm, spacing_mm);
}

}  // namespace isostack
