#include "recon/surface/stack_bounds.h"

#include <algorithm>

namespace isostack {

namespace {

using Values = std::function<Eigen::VectorXd(const Eigen::MatrixXd&)>;

/// An end of a parallel stack: the outermost plane, the way out, and the gap to the next plane.
struct StackEnd {
  SlicePose pose;
  Eigen::Vector3d outwards;
  double gap_mm;
};

std::vector<StackEnd> ends_of(std::vector<SlicePose> poses) {
  const SlicePose first = poses.front();
  if (std::any_of(poses.begin(), poses.end(), [&](const SlicePose& p) { return !are_parallel(first, p); })) return {};
  const auto height = [&](const SlicePose& pose) { return first.signed_distance_mm(pose.origin_mm); };
  std::sort(poses.begin(), poses.end(), [&](const auto& a, const auto& b) { return height(a) < height(b); });
  const auto in_one_plane = [&](const auto& a, const auto& b) { return height(b) - height(a) < 1e-3; };
  poses.erase(std::unique(poses.begin(), poses.end(), in_one_plane), poses.end());
  const std::size_t n = poses.size();
  if (n < 2) return {};
  return {{poses[0], -first.normal(), height(poses[1]) - height(poses[0])},
          {poses[n - 1], first.normal(), height(poses[n - 1]) - height(poses[n - 2])}};
}

/// Whether f is positive anywhere on the plane `distance_mm` beyond the end, opposite the contours.
bool goes_on(const StackEnd& end, double distance_mm, const std::vector<Eigen::Vector3d>& contour_points_mm,
             const Values& values) {
  Eigen::AlignedBox2d region;
  for (const Eigen::Vector3d& p : contour_points_mm) region.extend(end.pose.world_to_slice(p));
  constexpr int nodes = 64;  // along each side
  Eigen::MatrixXd points(3, nodes * nodes);
  for (int i = 0; i < nodes * nodes; ++i) {
    const int column = i % nodes, row = i / nodes;
    const Eigen::Vector2d fraction(column / (nodes - 1.0), row / (nodes - 1.0));
    const Eigen::Vector2d in_slice = region.min() + fraction.cwiseProduct(region.sizes());
    points.col(i) = end.pose.slice_to_world(in_slice) + distance_mm * end.outwards;
  }
  return (values(points).array() > 0).any();
}

}  // namespace

StackBounds stack_bounds(const std::vector<SlicePose>& poses, const std::vector<Eigen::Vector3d>& contour_points_mm,
                         const Values& values) {
  StackBounds bounds;
  for (const Eigen::Vector3d& p : contour_points_mm) bounds.box.extend(p);
  const double margin = bounds.box.diagonal().norm() / 4;
  bounds.box = {bounds.box.min().array() - margin, bounds.box.max().array() + margin};
  for (const StackEnd& end : ends_of(poses)) {
    const bool is_open = goes_on(end, 1.5 * end.gap_mm, contour_points_mm, values);
    const double reach_mm = (is_open ? 0.5 : 1.5) * end.gap_mm;
    bounds.half_spaces.emplace_back(-end.outwards, end.pose.origin_mm + reach_mm * end.outwards);
    bounds.open_end = bounds.open_end || is_open;
  }
  return bounds;
}

}  // namespace isostack
