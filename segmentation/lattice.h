#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "segmentation/field.h"

namespace isostack {

/// Steps between the nodes of a field, worked out once.
template <int D>
struct Lattice {
  explicit Lattice(const Field<D>& field) : spacing_mm(field.spacing_mm) {
    for (int axis = 0; axis < D; ++axis) {
      size[axis] = static_cast<std::size_t>(field.size[axis]);
      stride[axis] = static_cast<std::ptrdiff_t>(field.stride(axis));
      inverse_spacing[axis] = 1 / spacing_mm[axis];
    }
  }

  /// Bit 2·axis: the node before along the axis exists; bit 2·axis + 1: the node after.
  using Sides = std::uint8_t;
  static constexpr Sides all_sides = (1u << (2 * D)) - 1;
  static constexpr Sides before(int axis) { return static_cast<Sides>(1u << (2 * axis)); }
  static constexpr Sides after(int axis) { return static_cast<Sides>(2u << (2 * axis)); }

  Sides sides_of(std::size_t node) const {
    unsigned sides = 0;
    for (int axis = 0; axis < D; ++axis) {
      const std::size_t next = node / size[axis], position = node - next * size[axis];
      if (position > 0) sides |= before(axis);
      if (position + 1 < size[axis]) sides |= after(axis);
      node = next;
    }
    return static_cast<Sides>(sides);
  }

  /// visit(axis, step) with step = ± the axis' stride for every neighbour that exists.
  template <class Visit>
  void for_each_neighbour(Sides sides, Visit visit) const {
    for (int axis = 0; axis < D; ++axis) {
      if (sides & before(axis)) visit(axis, -stride[axis]);
      if (sides & after(axis)) visit(axis, stride[axis]);
    }
  }

  static std::size_t moved(std::size_t node, std::ptrdiff_t step) {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + step);
  }

  std::array<std::size_t, D> size;
  std::array<std::ptrdiff_t, D> stride;
  std::array<double, D> spacing_mm, inverse_spacing;
};

}  // namespace isostack
