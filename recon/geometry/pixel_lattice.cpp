#include "recon/geometry/pixel_lattice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isostack {

namespace {

/// Columns at which the row's line crosses the closed curve, added to `crossings`.
void add_crossings(const std::vector<Eigen::Vector2d>& pixels, std::vector<std::vector<double>>& crossings) {
  const int rows = static_cast<int>(crossings.size());
  for (std::size_t i = 0, previous = pixels.size() - 1; i < pixels.size(); previous = i++) {
    Eigen::Vector2d low = pixels[previous], high = pixels[i];
    if (low.y() > high.y()) std::swap(low, high);
    const int first = std::max(0, static_cast<int>(std::ceil(low.y())));
    for (int row = first; row < rows && row < high.y(); ++row)
      crossings[static_cast<std::size_t>(row)].push_back(low.x() +
                                                         (row - low.y()) / (high.y() - low.y()) * (high.x() - low.x()));
  }
}

}  // namespace

PixelLattice lattice_of(const ContourSlice& slice, const ContourStack& stack) {
  if ((slice.size_pixels.array() > 0).all()) return {slice.pose, slice.size_pixels};
  Eigen::AlignedBox2d box;
  for (const ContourSlice& other : stack.slices)
    for (const Contour& contour : other.contours)
      for (const Eigen::Vector2d& p : contour.points_mm)
        box.extend(slice.pose.slice_to_pixel(slice.pose.world_to_slice(other.pose.slice_to_world(p))));
  if (box.isEmpty()) return {slice.pose, {1, 1}};
  const Eigen::Vector2d margin = (0.1 * box.sizes()).array() + 1;
  const Eigen::Vector2d first = (box.min() - margin).array().floor();
  PixelLattice lattice{slice.pose, ((box.max() + margin - first).array().ceil() + 1).cast<int>()};
  lattice.pose.origin_mm = slice.pose.pixel_to_world(first);
  return lattice;
}

std::vector<Contour> moved_to(const SlicePose& to, const std::vector<Contour>& contours, const SlicePose& from) {
  std::vector<Contour> moved = contours;
  for (Contour& contour : moved)
    for (Eigen::Vector2d& p : contour.points_mm) p = to.world_to_slice(from.slice_to_world(p));
  return moved;
}

Image<std::uint8_t> pixels_inside(const std::vector<Contour>& contours, const SlicePose& contours_pose,
                                  const PixelLattice& lattice) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(lattice.size_pixels.y()));
  for (const Contour& contour : moved_to(lattice.pose, contours, contours_pose)) {
    std::vector<Eigen::Vector2d> pixels;
    for (const Eigen::Vector2d& p : contour.points_mm) pixels.push_back(lattice.pose.slice_to_pixel(p));
    add_crossings(pixels, crossings);
  }
  Image<std::uint8_t> inside = Image<std::uint8_t>::Zero(lattice.size_pixels.y(), lattice.size_pixels.x());
  for (Eigen::Index row = 0; row < inside.rows(); ++row) {
    std::vector<double>& at = crossings[static_cast<std::size_t>(row)];
    std::sort(at.begin(), at.end());
    for (std::size_t c = 0; c + 1 < at.size(); c += 2) {
      const auto first = std::max(Eigen::Index{0}, static_cast<Eigen::Index>(std::ceil(at[c])));
      const auto last = std::min(inside.cols() - 1, static_cast<Eigen::Index>(std::floor(at[c + 1])));
      if (first <= last) inside.row(row).segment(first, last - first + 1) = 1;
    }
  }
  return inside;
}

}  // namespace isostack
