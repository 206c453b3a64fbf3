#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "recon/geometry/slice.h"

namespace isostack {

/// Values at the nodes of a regular lattice in D dimensions, the first axis fastest.
/// In 2D axis 0 is x (columns) and axis 1 is y (rows).
template <int D>
struct Field {
  using Position = std::array<int, D>;

  Position size{};
  std::array<double, D> spacing_mm{};
  std::vector<float> values;

  double smallest_spacing_mm() const { return *std::min_element(spacing_mm.begin(), spacing_mm.end()); }

  std::size_t stride(int axis) const {
    std::size_t stride = 1;
    for (int i = 0; i < axis; ++i) stride *= static_cast<std::size_t>(size[i]);
    return stride;
  }

  Position position_of(std::size_t node) const {
    Position position;
    for (int axis = 0; axis < D; ++axis) {
      position[axis] = static_cast<int>(node % static_cast<std::size_t>(size[axis]));
      node /= static_cast<std::size_t>(size[axis]);
    }
    return position;
  }

  std::size_t node_at(const Position& position) const {
    std::size_t node = 0;
    for (int axis = D - 1; axis >= 0; --axis)
      node = node * static_cast<std::size_t>(size[axis]) + static_cast<std::size_t>(position[axis]);
    return node;
  }

  /// The value at a position at most one step outside, where the field goes on linearly: a surface
  /// leaves the field of view straight.
  double extrapolated(const Position& position) const {
    for (int axis = 0; axis < D; ++axis) {
      if (position[axis] >= 0 && position[axis] < size[axis]) continue;
      Position border = position, inner = position;
      border[axis] = std::clamp(position[axis], 0, size[axis] - 1);
      inner[axis] = std::clamp(2 * border[axis] - position[axis], 0, size[axis] - 1);
      return 2 * extrapolated(border) - extrapolated(inner);
    }
    return values[node_at(position)];
  }
};

/// A field that is read by several owners, for instance the image behind the terms of one evolution: copies of the
/// handle share the values.
template <int D>
class SharedField {
 public:
  SharedField(Field<D> field) : field_(std::make_shared<const Field<D>>(std::move(field))) {}
  const Field<D>& operator*() const { return *field_; }
  const Field<D>* operator->() const { return field_.get(); }

 private:
  std::shared_ptr<const Field<D>> field_;
};

inline Field<2> field_of(const Image<float>& image, const Eigen::Vector2d& spacing_mm) {
  Field<2> field{{static_cast<int>(image.cols()), static_cast<int>(image.rows())},
                 {spacing_mm.x(), spacing_mm.y()},
                 {image.data(), image.data() + image.size()}};
  return field;
}

inline Image<float> image_of(const Field<2>& field) {
  return Eigen::Map<const Image<float>>(field.values.data(), field.size[1], field.size[0]);
}

}  // namespace isostack
