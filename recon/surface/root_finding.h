#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/surface/scalar_field.h"

namespace isostack {

/// A segment whose end values differ in sign (≥ 0 counts as positive).
struct CrossedSegment {
  Eigen::Vector3d from_mm, to_mm;
  double from_value, to_value;
};

/// A root of the field on every segment, to `tolerance` (a fraction of the segment), by batched
/// regula falsi (Illinois). Roots keep `tolerance` from the segment's ends, so that roots of
/// segments that meet in a node never coincide.
std::vector<Eigen::Vector3d> roots_on_segments(const ScalarField& field, const std::vector<CrossedSegment>& segments,
                                               double tolerance);

}  // namespace isostack
