#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "recon/surface/scalar_field.h"

namespace isostack {

/// Nodes of a cubic lattice over a box, addressed by 64-bit keys, with the values asked for so far.
class CubicLattice {
 public:
  using Key = std::uint64_t;

  /// Covers `bounds` and one more cell on every side. Throws GeometryError when that takes more
  /// than 2^20 cells along an axis.
  CubicLattice(const Eigen::AlignedBox3d& bounds, double spacing_mm);

  static Key key(const Eigen::Vector3i& node);
  static Eigen::Vector3i node(Key key);
  static Key neighbour(Key key, int axis, int steps);

  Eigen::Vector3d position_mm(Key node) const;
  Key cell_containing(const Eigen::Vector3d& point_mm) const;
  bool contains_cell(Key cell) const;
  double spacing_mm() const { return spacing_mm_; }

  /// Evaluates the field at the corners of these cells where that has not been done yet.
  void evaluate_corners(const std::vector<Key>& cells, const ScalarField& field);
  double value(Key node) const { return values_.at(node); }
  std::array<double, 8> corner_values(Key cell) const;

 private:
  Eigen::Vector3d origin_mm_;
  double spacing_mm_;
  Eigen::Vector3i cell_count_;
  std::unordered_map<Key, double> values_;
};

}  // namespace isostack
