#pragma once

#include <cstddef>
#include <vector>

#include "recon/geometry/slice_pose.h"

namespace isostack {

/// Indices that put slices in order: those parallel to the first one (see are_parallel) by their
/// position along its normal, then those parallel to the first of the rest, and so on.
std::vector<std::size_t> order_along_normals(const std::vector<SlicePose>& poses);

}  // namespace isostack
