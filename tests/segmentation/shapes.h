#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/slice.h"

namespace isostack::test {

/// Image of value(x, y) at the pixel centres, (x, y) in slice mm.
template <class Function>
Image<float> sampled(int rows, int columns, const Eigen::Vector2d& spacing_mm, Function value) {
  Image<float> image(rows, columns);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      image(row, column) = static_cast<float>(value(column * spacing_mm.x(), row * spacing_mm.y()));
  return image;
}

/// Signed distance to a circle, positive inside.
struct Disc {
  double x, y, radius;
  double operator()(double at_x, double at_y) const { return radius - std::hypot(at_x - x, at_y - y); }
};

struct Distances {
  double mean = 0, largest = 0;
};

/// Distance of the contours' points from the circle.
inline Distances distances_to(const Disc& disc, const std::vector<Contour>& contours) {
  Distances result;
  std::size_t count = 0;
  for (const Contour& contour : contours)
    for (const Eigen::Vector2d& point : contour.points_mm) {
      const double distance = std::abs(disc(point.x(), point.y()));
      result.largest = std::max(result.largest, distance);
      result.mean += distance;
      ++count;
    }
  result.mean /= static_cast<double>(count);
  return result;
}

inline double total_area_mm2(const std::vector<Contour>& contours) {
  double area = 0;
  for (const Contour& contour : contours) area += signed_area_mm2(contour);
  return area;
}

/// One pixel apart, axis-aligned, 3 mm between slices.
inline SliceStack stack_of(const std::vector<Image<float>>& images, const Eigen::Vector2d& spacing_mm = {1, 1}) {
  SliceStack stack;
  stack.name = "test stack";
  for (std::size_t k = 0; k < images.size(); ++k) {
    Slice slice;
    slice.name = "slice " + std::to_string(k);
    slice.pose.origin_mm.z() = 3.0 * static_cast<double>(k);
    slice.pose.spacing_mm = spacing_mm;
    slice.pixels = images[k];
    stack.slices.push_back(slice);
  }
  return stack;
}

/// The message of the exception of type E that work() throws; empty when it throws none.
template <class E, class Work>
std::string message_of(Work work) {
  try {
    work();
  } catch (const E& error) {
    return error.what();
  }
  return {};
}

}  // namespace isostack::test
