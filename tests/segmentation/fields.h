#pragma once

#include <array>
#include <cmath>

#include "segmentation/field.h"

namespace isostack::test {

/// Field of value(p), p in mm from the first node.
template <int D, class Function>
Field<D> field_from(const std::array<int, D>& size, const std::array<double, D>& spacing_mm, Function value) {
  Field<D> field;
  field.size = size;
  field.spacing_mm = spacing_mm;
  std::size_t count = 1;
  for (int n : size) count *= static_cast<std::size_t>(n);
  field.values.resize(count);
  for (std::size_t node = 0; node < count; ++node) {
    const auto position = field.position_of(node);
    Eigen::Matrix<double, D, 1> p;
    for (int axis = 0; axis < D; ++axis) p[axis] = position[axis] * spacing_mm[axis];
    field.values[node] = static_cast<float>(value(p));
  }
  return field;
}

}  // namespace isostack::test
