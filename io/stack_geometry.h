#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/slice_pose.h"

namespace isostack {

/// The distance between a slice and the next one parallel to it, along the normal.
struct SliceGap {
  std::size_t after = 0;  ///< index of the first of the two slices
  double mm = 0;
};

/// How the slices of a stack lie to each other.
struct StackGeometry {
  int orientations = 0;        ///< number of different plane directions
  std::vector<SliceGap> gaps;  ///< between neighbours of one direction
  double tilt_deg = 0;         ///< largest angle between a direction's line of origins and its normal
};

/// Slices must be in the order of order_along_normals.
StackGeometry analyse_stack(const std::vector<SlicePose>& ordered);

/// What headers claim about the distances, to be compared with the positions.
struct ClaimedDistances {
  std::optional<double> slice_thickness_mm;
  std::optional<double> spacing_between_slices_mm;
};

/// Warnings a user should see before trusting the stack, each starting with its kind: "mixed
/// orientations", "gantry tilt", "uneven gaps", "missing slices", "overlapping slices" or
/// "differing spacing". `names` are the slices' names, in the same order.
std::vector<std::string> geometry_warnings(const StackGeometry& geometry, const std::vector<std::string>& names,
                                           const ClaimedDistances& claimed);

}  // namespace isostack
