#include "recon/constraints/image_constraints.h"

#include <algorithm>
#include <cmath>

namespace isostack {

namespace {

/// Slope of n values at i by central differences, one-sided at the ends; 0 when there is one value only.
template <class ValueAt>
double slope(ValueAt value_at, Eigen::Index i, Eigen::Index n) {
  const Eigen::Index before = std::max<Eigen::Index>(i - 1, 0), after = std::min(i + 1, n - 1);
  return after > before ? (double(value_at(after)) - double(value_at(before))) / double(after - before) : 0;
}

Eigen::Vector2d gradient_at(const Image<float>& image, Eigen::Index row, Eigen::Index column) {
  return {slope([&](Eigen::Index i) { return image(row, i); }, column, image.cols()),
          slope([&](Eigen::Index i) { return image(i, column); }, row, image.rows())};
}

}  // namespace

std::vector<ImageConstraint> image_constraints(const Image<float>& image, double level) {
  std::vector<ImageConstraint> constraints;
  const auto add_crossing = [&](Eigen::Index row, Eigen::Index column, Eigen::Index to_row, Eigen::Index to_column) {
    const double here = image(row, column), there = image(to_row, to_column);
    if ((here >= level) == (there >= level)) return;
    const double fraction = (level - here) / (there - here);
    const Eigen::Vector2d from(static_cast<double>(column), static_cast<double>(row));
    const Eigen::Vector2d to(static_cast<double>(to_column), static_cast<double>(to_row));
    const Eigen::Vector2d boundary = from + fraction * (to - from);
    const Eigen::Vector2d gradient =
        (1 - fraction) * gradient_at(image, row, column) + fraction * gradient_at(image, to_row, to_column);
    if (gradient.norm() > 0) constraints.push_back({boundary, boundary + gradient.normalized()});
  };
  for (Eigen::Index row = 0; row < image.rows(); ++row)
    for (Eigen::Index column = 0; column < image.cols(); ++column) {
      if (column + 1 < image.cols()) add_crossing(row, column, row, column + 1);
      if (row + 1 < image.rows()) add_crossing(row, column, row + 1, column);
    }
  return constraints;
}

ConstraintSet image_constraint_set(const SliceStack& stack, double level, std::size_t max_constraints) {
  std::vector<Eigen::Vector3d> boundary, inside;
  for (const Slice& slice : stack.slices)
    for (const ImageConstraint& c : image_constraints(slice.pixels, level)) {
      boundary.push_back(slice.pose.pixel_to_world(c.boundary_pixel));
      inside.push_back(slice.pose.pixel_to_world(c.normal_pixel));
    }
  const std::size_t most_pairs = std::max<std::size_t>(1, max_constraints / 2);
  const std::size_t stride = std::max<std::size_t>(1, (boundary.size() + most_pairs - 1) / most_pairs);
  const auto pairs = static_cast<Eigen::Index>((boundary.size() + stride - 1) / stride);
  ConstraintSet set;
  set.points.resize(3, 2 * pairs);
  set.values = Eigen::VectorXd::Zero(2 * pairs);
  set.values.tail(pairs).setOnes();
  for (Eigen::Index i = 0; i < pairs; ++i) {
    set.points.col(i) = boundary[static_cast<std::size_t>(i) * stride];
    set.points.col(pairs + i) = inside[static_cast<std::size_t>(i) * stride];
  }
  return set;
}

}  // namespace isostack
