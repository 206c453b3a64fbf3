#include "recon/distance/carry_outwards.h"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "recon/metrics/point_triangle.h"

namespace isostack {

namespace {

using Eigen::Vector3d;

class March {
 public:
  March(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid, const std::vector<std::uint8_t>& side,
        std::uint8_t mine, double limit_mm, CarriedDistances& known)
      : mesh_(mesh), topology_(topology), grid_(grid), side_(side), mine_(mine), limit_mm_(limit_mm), known_(known) {
    const Eigen::Matrix3d axes_mm = grid.index_to_world.linear();
    width_mm_ = axes_mm.colwise().norm().minCoeff() / 10;
  }

  void run() {
    for (int k = 0; k < grid_.size.z(); ++k)
      for (int j = 0; j < grid_.size.y(); ++j)
        for (int i = 0; i < grid_.size.x(); ++i)
          if (const std::size_t voxel = grid_.offset(i, j, k); known_.triangle[voxel] >= 0 && is_mine(voxel))
            hand_on({i, j, k}, voxel);
    for (current_ = 0; current_ < waiting_.size(); ++current_) {
      for (std::size_t n = 0; n < waiting_[current_].size(); ++n) {  // grows on the way
        const Waiting next = waiting_[current_][n];
        const std::size_t voxel = grid_.offset(next.at.x(), next.at.y(), next.at.z());
        if (next.mm != known_.mm[voxel]) continue;  // outdated
        look_round(next.at, voxel);
        hand_on(next.at, voxel);
      }
      std::vector<Waiting>().swap(waiting_[current_]);
    }
  }

 private:
  struct Waiting {
    Eigen::Vector3i at;
    float mm;
  };

  bool is_mine(std::size_t voxel) const { return side_.empty() || side_[voxel] == mine_; }

  double distance(int triangle, const Vector3d& point) const {
    const Eigen::Vector3i& t = mesh_.triangles[static_cast<std::size_t>(triangle)];
    return (closest_point_on_triangle({vertex_mm(mesh_, t[0]), vertex_mm(mesh_, t[1]), vertex_mm(mesh_, t[2])}, point) -
            point)
        .norm();
  }

  void hand_on(const Eigen::Vector3i& at, std::size_t voxel) {
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        Eigen::Vector3i there = at;
        there[axis] += step;
        if (there[axis] < 0 || there[axis] >= grid_.size[axis]) continue;
        const std::size_t other = grid_.offset(there.x(), there.y(), there.z());
        if (known_.mm[other] <= known_.mm[voxel] || known_.triangle[other] == known_.triangle[voxel] || !is_mine(other))
          continue;
        offer(there, other, known_.triangle[voxel]);
      }
  }

  void offer(const Eigen::Vector3i& at, std::size_t voxel, int triangle) {
    const auto mm = static_cast<float>(distance(triangle, grid_.index_to_world * at.cast<double>()));
    if (!(mm < known_.mm[voxel]) || static_cast<double>(mm) > limit_mm_) return;
    known_.mm[voxel] = mm;
    known_.triangle[voxel] = triangle;
    const auto bucket = std::max(current_, static_cast<std::size_t>(static_cast<double>(mm) / width_mm_));
    if (bucket >= waiting_.size()) waiting_.resize(bucket + 1);
    waiting_[bucket].push_back({at, mm});
  }

  /// Goes to the nearest of the triangles that share a corner, as long as that brings it nearer.
  void look_round(const Eigen::Vector3i& at, std::size_t voxel) {
    const Vector3d point = grid_.index_to_world * at.cast<double>();
    for (int from = -1; from != known_.triangle[voxel];) {
      from = known_.triangle[voxel];
      for (int i = 0; i < 3; ++i)
        for (const int triangle : topology_.triangles_of_vertex[corner(mesh_, from, i)])
          if (const auto mm = static_cast<float>(distance(triangle, point)); mm < known_.mm[voxel])
            known_.mm[voxel] = mm, known_.triangle[voxel] = triangle;
    }
  }

  const TriangleMesh& mesh_;
  const MeshTopology& topology_;
  const Grid& grid_;
  const std::vector<std::uint8_t>& side_;
  const std::uint8_t mine_;
  const double limit_mm_;
  CarriedDistances& known_;
  double width_mm_;
  std::size_t current_ = 0;
  std::vector<std::vector<Waiting>> waiting_;  ///< by distance; outdated entries are skipped
};

}  // namespace

void carry_outwards(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid,
                    const std::vector<std::uint8_t>& side, double limit_mm, CarriedDistances& known) {
  if (side.empty()) return March(mesh, topology, grid, side, 0, limit_mm, known).run();
  tbb::parallel_invoke([&] { March(mesh, topology, grid, side, 0, limit_mm, known).run(); },
                       [&] { March(mesh, topology, grid, side, 1, limit_mm, known).run(); });
}

}  // namespace isostack
