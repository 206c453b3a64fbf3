#pragma once

#include <cstddef>
#include <vector>

#include "segmentation/field.h"
#include "segmentation/lattice.h"

namespace isostack {

/// φ = 0 counts as inside, also −0.
inline bool is_inside(float phi) { return phi >= 0; }

/// True where a neighbour along an axis is on the other side of the zero set.
template <int D>
bool is_beside_curve(const Field<D>& phi, const Lattice<D>& lattice, std::size_t node,
                     typename Lattice<D>::Sides sides) {
  bool is_beside = false;
  const bool inside = is_inside(phi.values[node]);
  lattice.for_each_neighbour(sides, [&](int, std::ptrdiff_t step) {
    is_beside = is_beside || is_inside(phi.values[lattice.moved(node, step)]) != inside;
  });
  return is_beside;
}

/// Unsigned distance in mm from a node beside the zero set of `phi` (any scale) to it: from the second-order expansion
/// of phi along its normal where phi is smooth at the scale of a pixel (the zero set may then differ by O(h³)
/// from the linear crossings), else from the crossings on the lattice lines, 1/d² = Σ 1/d_i².
template <int D>
double distance_beside_curve(const Field<D>& phi, const Lattice<D>& lattice, std::size_t node,
                             typename Lattice<D>::Sides sides);

/// All nodes beside the curve, ascending.
template <int D>
std::vector<std::size_t> nodes_beside_curve(const Field<D>& phi, const Lattice<D>& lattice);

/// Gives these nodes their signed distance in mm, worked out for all of them before the first is changed.
template <int D>
void set_distances_beside_curve(Field<D>& phi, const Lattice<D>& lattice, const std::vector<std::size_t>& nodes);

extern template double distance_beside_curve(const Field<2>&, const Lattice<2>&, std::size_t, std::uint8_t);
extern template double distance_beside_curve(const Field<3>&, const Lattice<3>&, std::size_t, std::uint8_t);
extern template std::vector<std::size_t> nodes_beside_curve(const Field<2>&, const Lattice<2>&);
extern template std::vector<std::size_t> nodes_beside_curve(const Field<3>&, const Lattice<3>&);
extern template void set_distances_beside_curve(Field<2>&, const Lattice<2>&, const std::vector<std::size_t>&);
extern template void set_distances_beside_curve(Field<3>&, const Lattice<3>&, const std::vector<std::size_t>&);

}  // namespace isostack
