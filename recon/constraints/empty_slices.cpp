#include "recon/constraints/empty_slices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace isostack {

namespace {

/// The parallel slice nearest to `slice` on the given side of it; null if there is none.
const ContourSlice* nearest_parallel(const ContourStack& stack, const ContourSlice& slice, double side) {
  const ContourSlice* nearest = nullptr;
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (const ContourSlice& other : stack.slices) {
    if (&other == &slice || !are_parallel(slice.pose, other.pose)) continue;
    const double distance = side * slice.pose.signed_distance_mm(other.pose.origin_mm);
    if (distance > 1e-6 && distance < nearest_mm) nearest = &other, nearest_mm = distance;
  }
  return nearest;
}

/// Points of the neighbour's organ on a lattice; the middle of a contour too small for any.
std::vector<Eigen::Vector2d> points_inside(const ContourSlice& slice, double step_mm) {
  std::vector<Eigen::Vector2d> points;
  Eigen::AlignedBox2d box;
  for (const Contour& contour : slice.contours)
    for (const Eigen::Vector2d& p : contour.points_mm) box.extend(p);
  for (double y = box.min().y() + step_mm / 2; y < box.max().y(); y += step_mm)
    for (double x = box.min().x() + step_mm / 2; x < box.max().x(); x += step_mm)
      if (is_inside(slice.contours, {x, y})) points.emplace_back(x, y);
  if (points.empty()) {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& p : slice.contours.front().points_mm) middle += p;
    points.emplace_back(middle / static_cast<double>(slice.contours.front().points_mm.size()));
  }
  return points;
}

}  // namespace

std::vector<OutsidePoint> points_in_empty_slices(const ContourStack& stack) {
  std::vector<OutsidePoint> result;
  for (const ContourSlice& slice : stack.slices) {
    if (!slice.contours.empty()) continue;
    for (const double side : {-1.0, 1.0}) {
      const ContourSlice* neighbour = nearest_parallel(stack, slice, side);
      if (neighbour == nullptr || neighbour->contours.empty()) continue;
      const double gap_mm = std::abs(slice.pose.signed_distance_mm(neighbour->pose.origin_mm));
      const double step_mm = std::max(gap_mm, 4 * slice.pose.spacing_mm.maxCoeff());
      for (const Eigen::Vector2d& p : points_inside(*neighbour, step_mm)) {
        const Eigen::Vector3d in_neighbour = neighbour->pose.slice_to_world(p);
        const Eigen::Vector3d here = slice.pose.slice_to_world(slice.pose.world_to_slice(in_neighbour));
        result.push_back({here, -gap_mm / 2});
      }
    }
  }
  return result;
}

double half_gap_to_contours_mm(const ContourStack& stack, const ContourSlice& slice) {
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (const ContourSlice& other : stack.slices) {
    if (other.contours.empty() || !are_parallel(slice.pose, other.pose)) continue;
    nearest_mm = std::min(nearest_mm, std::abs(slice.pose.signed_distance_mm(other.pose.origin_mm)));
  }
  return std::isfinite(nearest_mm) ? nearest_mm / 2 : 4 * slice.pose.spacing_mm.minCoeff();
}

}  // namespace isostack
