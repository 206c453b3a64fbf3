#include "recon/constraints/parallel_neighbours.h"

namespace isostack {

std::optional<ParallelNeighbour> next_along_normal(const ContourStack& stack, std::size_t s) {
  const SlicePose& pose = stack.slices[s].pose;
  std::optional<ParallelNeighbour> next;
  for (std::size_t i = 0; i < stack.slices.size(); ++i) {
    const double height_mm = pose.signed_distance_mm(stack.slices[i].pose.origin_mm);
    if (i == s || height_mm <= 1e-3 || (next && height_mm >= next->height_mm)) continue;
    if (are_parallel(pose, stack.slices[i].pose)) next = ParallelNeighbour{i, height_mm};
  }
  return next;
}

}  // namespace isostack
