#include "segmentation/rasterize.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

std::optional<int> plane_of(const ContourSlice& slice, const Grid& grid, const Eigen::Affine3d& world_to_index) {
  const Eigen::Vector3d origin = world_to_index * slice.pose.origin_mm;
  const Eigen::Vector3d far_x = world_to_index * slice.pose.slice_to_world({100, 0});
  const Eigen::Vector3d far_y = world_to_index * slice.pose.slice_to_world({0, 100});
  const int k = static_cast<int>(std::lround(origin.z()));
  const double off = std::max({std::abs(origin.z() - k), std::abs(far_x.z() - k), std::abs(far_y.z() - k)});
  if (off > 0.1 || k < 0 || k >= grid.size.z()) return std::nullopt;
  return k;
}

// Centres are shifted a little so that a curve through pixel centres has them on one side whatever the
// rounding, the same for both organs it may bound.
constexpr double shift_x = 1.4142136e-7, shift_y = 1.2360679e-7;

/// Columns at which the row's centre line crosses the contours.
std::vector<double> crossings_of_row(const std::vector<std::vector<Eigen::Vector2d>>& loops, int row) {
  const double y = row + shift_y;
  std::vector<double> crossings;
  for (const auto& loop : loops)
    for (std::size_t i = 0, previous = loop.size() - 1; i < loop.size(); previous = i++) {
      const Eigen::Vector2d &a = loop[previous], &b = loop[i];
      if ((a.y() > y) == (b.y() > y)) continue;
      crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace

void rasterize(const ContourStack& organ, std::uint16_t label, LabelVolume& labels) {
  const Eigen::Affine3d world_to_index = labels.grid.index_to_world.inverse();
  for (const ContourSlice& slice : organ.slices) {
    if (slice.contours.empty()) continue;
    const std::optional<int> k = plane_of(slice, labels.grid, world_to_index);
    if (!k)
      throw GeometryError(slice.name, "it does not lie on a plane of the label grid",
                          "write contours instead, or use a grid made of these slices");
    std::vector<std::vector<Eigen::Vector2d>> loops;
    for (const Contour& contour : slice.contours) {
      loops.emplace_back();
      for (const Eigen::Vector2d& p : contour.points_mm)
        loops.back().push_back((world_to_index * slice.pose.slice_to_world(p)).head<2>());
    }
    for (int row = 0; row < labels.grid.size.y(); ++row) {
      const std::vector<double> crossings = crossings_of_row(loops, row);
      for (std::size_t c = 0; c + 1 < crossings.size(); c += 2) {
        const int first = std::max(0, static_cast<int>(std::ceil(crossings[c] - shift_x)));
        const int last = std::min(labels.grid.size.x() - 1, static_cast<int>(std::floor(crossings[c + 1] - shift_x)));
        for (int i = first; i <= last; ++i) labels.at(i, row, *k) = label;
      }
    }
  }
}

}  // namespace isostack
