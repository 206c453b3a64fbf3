#include "recon/surface/surface_seeds.h"

#include <algorithm>
#include <cmath>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// Values at the nodes of a lattice over a box, x fastest.
class NodeValues {
 public:
  NodeValues(const ScalarField& field, const Eigen::AlignedBox3d& box, double spacing_mm) : spacing_mm_(spacing_mm) {
    constexpr double most_nodes = 1e8;
    const Eigen::Vector3d cells = (box.sizes() / spacing_mm).array().ceil().max(1.0);
    if (!(spacing_mm > 0) || (cells.array() + 1).prod() > most_nodes)
      throw GeometryError("surface", "the resolution is too fine for an object of this size",
                          "give a coarser --resolution in mm");
    count_ = cells.cast<int>() + Eigen::Vector3i::Ones();
    origin_mm_ = box.center() - cells * spacing_mm / 2;
    // A layer of nodes at a time keeps the batches small.
    const Eigen::Index layer = Eigen::Index{count_.x()} * count_.y();
    values_.resize(layer * count_.z());
    constexpr Eigen::Index batch_nodes = 100'000;
    const Eigen::Index layers = std::max<Eigen::Index>(1, batch_nodes / layer);
    for (Eigen::Index k = 0; k < count_.z(); k += layers) {
      const Eigen::Index last = std::min<Eigen::Index>(k + layers, count_.z());
      Eigen::Matrix3Xd points(3, (last - k) * layer);
      for (Eigen::Index n = 0; n < points.cols(); ++n) points.col(n) = position_mm(node(k * layer + n));
      values_.segment(k * layer, points.cols()) = field.values(points);
    }
  }

  Eigen::Index size() const { return values_.size(); }
  Eigen::Vector3i node(Eigen::Index n) const {
    return {static_cast<int>(n % count_.x()), static_cast<int>(n / count_.x() % count_.y()),
            static_cast<int>(n / count_.x() / count_.y())};
  }
  Eigen::Vector3d position_mm(const Eigen::Vector3i& at) const { return origin_mm_ + at.cast<double>() * spacing_mm_; }
  double operator[](Eigen::Index n) const { return values_[n]; }
  Eigen::Index step(int axis) const {
    return axis == 0 ? 1 : axis == 1 ? count_.x() : Eigen::Index{count_.x()} * count_.y();
  }
  int count(int axis) const { return count_[axis]; }

 private:
  double spacing_mm_;
  Eigen::Vector3i count_;
  Eigen::Vector3d origin_mm_;
  Eigen::VectorXd values_;
};

/// Where the straight line between two values of different sign is zero.
Eigen::Vector3d zero_between(const Eigen::Vector3d& from, double from_value, const Eigen::Vector3d& to,
                             double to_value) {
  return from + from_value / (from_value - to_value) * (to - from);
}

void add_crossings(const NodeValues& nodes, std::vector<Eigen::Vector3d>& seeds) {
  for (Eigen::Index n = 0; n < nodes.size(); ++n) {
    const Eigen::Vector3i at = nodes.node(n);
    for (int axis = 0; axis < 3; ++axis) {
      if (at[axis] + 1 == nodes.count(axis)) continue;
      const double here = nodes[n], next = nodes[n + nodes.step(axis)];
      if ((here >= 0) == (next >= 0)) continue;
      seeds.push_back(
          zero_between(nodes.position_mm(at), here, nodes.position_mm(at + Eigen::Vector3i::Unit(axis)), next));
    }
  }
}

/// Whether the value is the nearest to zero among its neighbours, which have its sign, and nearer than what it changes
/// by from node to node: zero may be reached, and left again, before the next nodes.
bool may_hide_zero(const NodeValues& nodes, Eigen::Index n, const Eigen::Vector3i& at) {
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double change = 0;
    for (const int side : {-1, 1}) {
      if (at[axis] + side < 0 || at[axis] + side == nodes.count(axis)) continue;
      const double value = nodes[n + side * nodes.step(axis)];
      if ((value >= 0) != (nodes[n] >= 0) || std::abs(value) < std::abs(nodes[n])) return false;
      change = std::max(change, std::abs(value - nodes[n]));
    }
    reach += change;
  }
  return std::abs(nodes[n]) <= reach;
}

void add_hidden(const ScalarField& field, const NodeValues& nodes, double spacing_mm,
                std::vector<Eigen::Vector3d>& seeds) {
  constexpr int quarters = 3;
  struct Look {
    Eigen::Vector3d node_mm;
    double node_value;
  };
  std::vector<Look> looks;
  std::vector<Eigen::Vector3d> points;
  for (Eigen::Index n = 0; n < nodes.size(); ++n) {
    const Eigen::Vector3i at = nodes.node(n);
    if (!may_hide_zero(nodes, n, at)) continue;
    for (int k = -quarters; k <= quarters; ++k)
      for (int j = -quarters; j <= quarters; ++j)
        for (int i = -quarters; i <= quarters; ++i) {
          points.push_back(nodes.position_mm(at) + spacing_mm / (quarters + 1) * Eigen::Vector3d(i, j, k));
          looks.push_back({nodes.position_mm(at), nodes[n]});
        }
  }
  if (points.empty()) return;
  const Eigen::VectorXd values =
      field.values(Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3, std::ssize(points)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double value = values[static_cast<Eigen::Index>(i)];
    if ((value >= 0) == (looks[i].node_value >= 0)) continue;
    seeds.push_back(zero_between(looks[i].node_mm, looks[i].node_value, points[i], value));
  }
}

}  // namespace

std::vector<Eigen::Vector3d> surface_seeds(const ScalarField& field, const Eigen::AlignedBox3d& box,
                                           double spacing_mm) {
  const NodeValues nodes(field, box, spacing_mm);
  std::vector<Eigen::Vector3d> seeds;
  add_crossings(nodes, seeds);
  add_hidden(field, nodes, spacing_mm, seeds);
  return seeds;
}

}  // namespace isostack
