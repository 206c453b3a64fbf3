#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace isostack {

/// The interpolation nodes of one octree level: equispaced along each axis. Large orders reach a little
/// beyond the cell: that keeps points away from the ends of the grid, where equispaced
/// interpolation is inaccurate and magnifies rounding. Lengths are in half cell widths.
class NodeGrid {
 public:
  NodeGrid() = default;
  /// `order` nodes along each axis; a flat axis (all points in one plane across it) needs one.
  NodeGrid(int order, const std::array<bool, 3>& flat);

  int count(int axis) const { return counts_[static_cast<std::size_t>(axis)]; }
  std::size_t node_count() const { return static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]); }
  int order() const { return order_; }
  double spacing() const { return nodes_.size() > 1 ? nodes_[1] - nodes_[0] : 0; }
  /// Positions and barycentric-style factors 1/∏(node_a − node_b) along an axis that is not flat.
  const std::vector<double>& nodes() const { return nodes_; }
  const std::vector<double>& factors() const { return factors_; }
  /// The Lagrange polynomials of an axis at position t.
  std::vector<double> basis(int axis, double t) const;

 private:
  int order_ = 1;
  std::array<int, 3> counts_{1, 1, 1};
  std::vector<double> nodes_, factors_;
};

/// Eight sibling cells are kept side by side, one per SIMD lane, in the order of Octree::Cell::octant.
constexpr std::size_t sibling_lanes = 8;

/// Interpolation from the grids of eight siblings to their parent's, one matrix per axis and lane.
struct GridTransfer {
  NodeGrid child, parent;
  /// Per axis [child node][parent node][lane].
  std::array<std::vector<double>, 3> to_parent;
  /// Per axis [parent node][child node][lane].
  std::array<std::vector<double>, 3> to_child;

  GridTransfer(const NodeGrid& child, const NodeGrid& parent);
};

}  // namespace isostack
