#include "recon/surface/stack_bounds.h"

#include <algorithm>
#include <cmath>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

using Values = std::function<Eigen::VectorXd(const Eigen::MatrixXd&)>;

/// An end of a parallel stack: the outermost plane, the way out, and the gap to the next plane.
struct StackEnd {
  SlicePose pose;
  Eigen::Vector3d outwards;
  double gap_mm;
};

/// The planes of a parallel stack from bottom to top, each once; none when slices cross.
std::vector<SlicePose> planes_of(std::vector<SlicePose> poses) {
  const SlicePose first = poses.front();
  if (std::any_of(poses.begin(), poses.end(), [&](const SlicePose& p) { return !are_parallel(first, p); })) return {};
  const auto height = [&](const SlicePose& pose) { return first.signed_distance_mm(pose.origin_mm); };
  std::sort(poses.begin(), poses.end(), [&](const auto& a, const auto& b) { return height(a) < height(b); });
  const auto in_one_plane = [&](const auto& a, const auto& b) { return height(b) - height(a) < 1e-3; };
  poses.erase(std::unique(poses.begin(), poses.end(), in_one_plane), poses.end());
  return poses;
}

/// In order of height; planes that lack contours beyond `lowest` and `highest` are passed over.
std::vector<StackEnd> ends_of(const std::vector<SlicePose>& planes, std::size_t lowest, std::size_t highest) {
  if (planes.size() < 2) return {};
  const Eigen::Vector3d normal = planes.front().normal();
  const Eigen::Vector3d up = normal.dot(planes.back().origin_mm - planes.front().origin_mm) > 0 ? normal : -normal;
  const auto gap_above = [&](std::size_t i) { return (planes[i + 1].origin_mm - planes[i].origin_mm).dot(up); };
  return {{planes[lowest], -up, gap_above(lowest > 0 ? lowest - 1 : 0)},
          {planes[highest], up, gap_above(std::min(highest, planes.size() - 2))}};
}

std::vector<StackEnd> outermost_with_contours(const std::vector<SlicePose>& planes,
                                              const std::vector<Eigen::Vector3d>& contour_points_mm) {
  if (planes.size() < 2)
    throw GeometryError("--caps", "flat and open ends need an outermost slice, which only parallel slices have",
                        "use round ends for slices that cross");
  const auto distance = [&](std::size_t plane, const Eigen::Vector3d& p) {
    return std::abs(planes[plane].signed_distance_mm(p));
  };
  std::size_t lowest = planes.size() - 1, highest = 0;
  for (const Eigen::Vector3d& p : contour_points_mm) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < planes.size(); ++i)
      if (distance(i, p) < distance(nearest, p)) nearest = i;
    lowest = std::min(lowest, nearest);
    highest = std::max(highest, nearest);
  }
  return ends_of(planes, lowest, highest);
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
                         const Values& values, Caps caps) {
  StackBounds bounds;
  for (const Eigen::Vector3d& p : contour_points_mm) bounds.box.extend(p);
  const double margin = bounds.box.diagonal().norm() / 4;
  bounds.box = {bounds.box.min().array() - margin, bounds.box.max().array() + margin};
  const std::vector<SlicePose> planes = planes_of(poses);
  if (caps != Caps::round) {
    for (const StackEnd& end : outermost_with_contours(planes, contour_points_mm)) {
      const double reach_mm = caps == Caps::flat ? 0.5 * end.gap_mm : 1.5 * end.gap_mm;  // open: clipped at the slice
      bounds.half_spaces.emplace_back(-end.outwards, end.pose.origin_mm + reach_mm * end.outwards);
      bounds.ends.emplace_back(-end.outwards, end.pose.origin_mm);
    }
    return bounds;
  }
  for (const StackEnd& end : ends_of(planes, 0, planes.size() - 1)) {
    const bool is_open = goes_on(end, 1.5 * end.gap_mm, contour_points_mm, values);
    const double reach_mm = (is_open ? 0.5 : 1.5) * end.gap_mm;
    bounds.half_spaces.emplace_back(-end.outwards, end.pose.origin_mm + reach_mm * end.outwards);
    bounds.open_end = bounds.open_end || is_open;
  }
  return bounds;
}

}  // namespace isostack
