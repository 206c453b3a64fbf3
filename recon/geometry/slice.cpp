#include "recon/geometry/slice.h"

namespace isostack {

std::vector<double> positions_along_normal_mm(const std::vector<Slice>& slices) {
  std::vector<double> positions_mm;
  if (slices.empty()) return positions_mm;
  const Eigen::Vector3d normal = slices.front().pose.normal();
  positions_mm.reserve(slices.size());
  for (const Slice& slice : slices) positions_mm.push_back(slice.pose.origin_mm.dot(normal));
  return positions_mm;
}

}  // namespace isostack
