#include "io/slice_order.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace isostack {

std::vector<std::size_t> order_along_normals(const std::vector<SlicePose>& poses) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& members) {
      return are_parallel(poses[members.front()], poses[i]);
    });
    if (group == groups.end())
      groups.push_back({i});
    else
      group->push_back(i);
  }
  std::vector<std::size_t> order;
  for (auto& members : groups) {
    const Eigen::Vector3d normal = poses[members.front()].normal();
    std::stable_sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
      return poses[a].origin_mm.dot(normal) < poses[b].origin_mm.dot(normal);
    });
    order.insert(order.end(), members.begin(), members.end());
  }
  return order;
}

}  // namespace isostack
