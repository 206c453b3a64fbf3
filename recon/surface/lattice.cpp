#include "recon/surface/lattice.h"

#include <cmath>
#include <limits>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr int bits = 21;
constexpr CubicLattice::Key mask = (CubicLattice::Key{1} << bits) - 1;

}  // namespace

CubicLattice::CubicLattice(const Eigen::AlignedBox3d& bounds, double spacing_mm) : spacing_mm_(spacing_mm) {
  const Eigen::Vector3d cells = (bounds.sizes() / spacing_mm).array().ceil() + 2;
  if (!(spacing_mm > 0) || cells.maxCoeff() > double(1 << (bits - 1)))
    throw GeometryError("surface", "the resolution is too fine for an object of this size",
                        "give a coarser --resolution in mm");
  cell_count_ = cells.cast<int>();
  origin_mm_ = bounds.center() - cell_count_.cast<double>() * spacing_mm / 2;
}

CubicLattice::Key CubicLattice::key(const Eigen::Vector3i& node) {
  return static_cast<Key>(node.x()) | static_cast<Key>(node.y()) << bits | static_cast<Key>(node.z()) << 2 * bits;
}

Eigen::Vector3i CubicLattice::node(Key key) {
  return {static_cast<int>(key & mask), static_cast<int>(key >> bits & mask), static_cast<int>(key >> 2 * bits & mask)};
}

CubicLattice::Key CubicLattice::neighbour(Key key, int axis, int steps) {
  return key + (static_cast<Key>(static_cast<std::int64_t>(steps)) << (bits * axis));
}

Eigen::Vector3d CubicLattice::position_mm(Key key) const { return origin_mm_ + node(key).cast<double>() * spacing_mm_; }

CubicLattice::Key CubicLattice::cell_containing(const Eigen::Vector3d& point_mm) const {
  const Eigen::Vector3i cell = ((point_mm - origin_mm_) / spacing_mm_).array().floor().cast<int>();
  return key(cell.cwiseMax(0).cwiseMin(cell_count_ - Eigen::Vector3i::Ones()));
}

bool CubicLattice::contains_cell(Key cell) const { return (node(cell).array() < cell_count_.array()).all(); }

void CubicLattice::evaluate_corners(const std::vector<Key>& cells, const ScalarField& field) {
  std::vector<Key> missing;
  for (const Key cell : cells)
    for (int corner = 0; corner < 8; ++corner) {
      const Key node_key = cell + key({corner & 1, corner >> 1 & 1, corner >> 2});
      if (values_.emplace(node_key, std::numeric_limits<double>::quiet_NaN()).second) missing.push_back(node_key);
    }
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(missing.size()));
  for (std::size_t i = 0; i < missing.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = position_mm(missing[i]);
  const Eigen::VectorXd found = field.values(points);
  for (std::size_t i = 0; i < missing.size(); ++i) values_[missing[i]] = found[static_cast<Eigen::Index>(i)];
}

std::array<double, 8> CubicLattice::corner_values(Key cell) const {
  std::array<double, 8> result{};
  for (int corner = 0; corner < 8; ++corner)
    result[static_cast<std::size_t>(corner)] = value(cell + key({corner & 1, corner >> 1 & 1, corner >> 2}));
  return result;
}

}  // namespace isostack
