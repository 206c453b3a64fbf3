#include "segmentation/components.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

struct Voxel {
  int plane, row, column;
};

/// Changes the 6-connected region of value `from` around the seed to `to`; returns its size.
std::size_t flood(std::vector<Mask>& planes, const Voxel& seed, std::uint8_t from, std::uint8_t to) {
  constexpr std::array<Voxel, 6> steps = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};
  std::size_t count = 0;
  std::vector<Voxel> pending;
  const auto visit = [&](const Voxel& at) {
    if (at.plane < 0 || at.plane >= static_cast<int>(planes.size())) return;
    Mask& mask = planes[static_cast<std::size_t>(at.plane)];
    if (at.row < 0 || at.row >= mask.rows() || at.column < 0 || at.column >= mask.cols()) return;
    if (mask(at.row, at.column) != from) return;
    mask(at.row, at.column) = to;
    ++count;
    pending.push_back(at);
  };
  visit(seed);
  while (!pending.empty()) {
    const Voxel at = pending.back();
    pending.pop_back();
    for (const Voxel& step : steps) visit({at.plane + step.plane, at.row + step.row, at.column + step.column});
  }
  return count;
}

template <class Visit>
void for_each_voxel(const std::vector<Mask>& planes, Visit visit) {
  for (int plane = 0; plane < static_cast<int>(planes.size()); ++plane) {
    const Mask& mask = planes[static_cast<std::size_t>(plane)];
    for (int row = 0; row < mask.rows(); ++row)
      for (int column = 0; column < mask.cols(); ++column) visit(Voxel{plane, row, column}, mask(row, column));
  }
}

bool raster_matches(const Slice& a, const Slice& b) {
  constexpr double tolerance = 1e-3;  // radians, and relative for the spacing
  return a.pixels.rows() == b.pixels.rows() && a.pixels.cols() == b.pixels.cols() &&
         (a.pose.x_axis - b.pose.x_axis).norm() < tolerance && (a.pose.y_axis - b.pose.y_axis).norm() < tolerance &&
         (a.pose.spacing_mm - b.pose.spacing_mm).norm() < tolerance * b.pose.spacing_mm.norm();
}

}  // namespace

Mask fill_holes(const Mask& mask) {
  constexpr std::uint8_t reached = 2;
  std::vector<Mask> planes = {mask};
  const int rows = static_cast<int>(mask.rows()), columns = static_cast<int>(mask.cols());
  for (int row = 0; row < rows; ++row)
    for (int column : {0, columns - 1}) flood(planes, {0, row, column}, 0, reached);
  for (int column = 0; column < columns; ++column)
    for (int row : {0, rows - 1}) flood(planes, {0, row, column}, 0, reached);
  return (planes.front() != reached).cast<std::uint8_t>();
}

std::vector<Mask> largest_component(std::vector<Mask> masks) {
  constexpr std::uint8_t organ = 1, counted = 2, kept = 3;
  for (const Mask& mask : masks)
    if (mask.rows() != masks.front().rows() || mask.cols() != masks.front().cols())
      throw GeometryError("largest component", "the slices differ in size", "leave out `largest`");
  std::size_t largest = 0;
  Voxel seed{0, 0, 0};
  for_each_voxel(masks, [&](const Voxel& at, std::uint8_t value) {
    if (value != organ) return;
    const std::size_t size = flood(masks, at, organ, counted);
    if (size <= largest) return;
    largest = size;
    seed = at;
  });
  if (largest > 0) flood(masks, seed, counted, kept);
  for (Mask& mask : masks) mask = (mask == kept).cast<std::uint8_t>().eval();
  return masks;
}

std::vector<std::size_t> stacking_order(const SliceStack& stack) {
  for (const Slice& slice : stack.slices)
    if (!raster_matches(slice, stack.slices.front()))
      throw GeometryError(slice.name,
                          "it is not parallel to " + stack.slices.front().name +
                              " with the same axes, spacing and size, so what is connected in 3D is not defined",
                          "leave out `largest` and seeds, or segment each series of parallel slices by itself");
  const std::vector<double> positions_mm = positions_along_normal_mm(stack.slices);
  std::vector<std::size_t> order(stack.slices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return positions_mm[a] < positions_mm[b]; });
  return order;
}

}  // namespace isostack
