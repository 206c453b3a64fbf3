#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// The straight line two planes share, world mm.
struct PlaneLine {
  Eigen::Vector3d origin_mm;
  Eigen::Vector3d direction;  ///< unit

  Eigen::Vector3d at(double place_mm) const { return origin_mm + place_mm * direction; }
};

/// A part of such a line, from place to place; empty when first > last.
struct LineRange {
  double first_mm, last_mm;

  bool empty() const { return !(first_mm < last_mm); }
  double length_mm() const { return empty() ? 0 : last_mm - first_mm; }
};

/// Where the line enters or leaves a slice's contours.
struct ContourCrossing {
  double place_mm;
  Eigen::Vector3d inward;  ///< unit normal of the contour there, in the slice's plane, world frame
};

/// The planes' common line; nothing for parallel planes (see are_parallel).
std::optional<PlaneLine> line_between(const SlicePose& a, const SlicePose& b);

/// The part of a plane that `contours_box` (world mm) projects to, and a tenth more. Slice coordinates, mm.
Eigen::AlignedBox2d around_contours(const SlicePose& pose, const Eigen::AlignedBox3d& contours_box);

/// The part of a slice that says something: its image, or without one the part around the contours.
/// Slice coordinates, mm.
Eigen::AlignedBox2d field_of_view(const ContourSlice& slice, const Eigen::AlignedBox3d& contours_box);

/// The part of the line, which lies in the slice's plane, within the rectangle `region` (slice coordinates, mm).
LineRange range_within(const PlaneLine& line, const SlicePose& pose, const Eigen::AlignedBox2d& region);

/// All crossings of the line with the contours, in order along it: even-odd, so the line is outside before the first
/// and inside after it.
std::vector<ContourCrossing> crossings_along(const PlaneLine& line, const ContourSlice& slice);

/// Box round all contours, world mm.
Eigen::AlignedBox3d box_of_contours(const ContourStack& stack);

}  // namespace isostack
