#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isostack {

/// The cube an octree divides, and the axes along which it has any extent.
struct OctreeDomain {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double width = 1;

  /// The smallest cube around points (n × N, n ≤ 3; missing axes are 0), widened by `margin` × its width.
  static OctreeDomain around(const Eigen::MatrixXd& points, double margin);
  /// Widened further, by less than half, such that octree leaves at some depth hold about `leaf_size` of the
  /// points: between two depths the best leaf size would otherwise be missed by up to a factor of two.
  static OctreeDomain fitted(const Eigen::MatrixXd& points, double margin, int leaf_size);
  bool contains(const Eigen::Ref<const Eigen::VectorXd>& point) const;
};

/// Points of at most three dimensions sorted into the cells of an octree. Every occupied cell is
/// divided down to one common depth; denser ones further, so that no leaf holds very many.
class Octree {
 public:
  struct Cell {
    std::array<int, 3> place;               ///< integer coordinates at the cell's level
    std::uint32_t first, last;              ///< its points in tree order
    std::uint32_t first_child, last_child;  ///< indices into the next level; equal for a leaf
    std::uint32_t parent;                   ///< index into the level above
    bool leaf() const { return first_child == last_child; }
    std::uint32_t count() const { return last - first; }
    int octant() const { return (place[0] & 1) * 4 + (place[1] & 1) * 2 + (place[2] & 1); }
  };

  /// `points` is n × N. A depth < 0 chooses the common depth such that leaves hold `leaf_size`
  /// points on average. No cell is divided below level `deepest`.
  Octree(const Eigen::MatrixXd& points, const OctreeDomain& domain, int leaf_size, int depth = -1, int deepest = 20);
  /// In the domain of another tree, divided down to its common depth and further just where it is:
  /// a place then belongs to the same leaf whatever points come with it.
  Octree(const Eigen::MatrixXd& points, const Octree& like);

  int depth() const { return depth_; }  ///< the common depth
  int level_count() const { return static_cast<int>(levels_.size()); }
  const std::vector<Cell>& level(int l) const { return levels_[static_cast<std::size_t>(l)]; }
  double cell_width(int l) const { return domain_.width / static_cast<double>(1 << l); }
  Eigen::Vector3d cell_centre(int l, const Cell& cell) const;
  const OctreeDomain& domain() const { return domain_; }

  std::size_t point_count() const { return order_.size(); }
  /// order()[k] is the column of the k-th point in tree order.
  const std::vector<std::uint32_t>& order() const { return order_; }
  /// Coordinates relative to the domain's centre, in tree order.
  const std::vector<double>& coordinates(int axis) const { return coordinates_[static_cast<std::size_t>(axis)]; }

 private:
  std::vector<std::uint64_t> sort_points(const Eigen::MatrixXd& points);
  /// `is_divided(level, cell)` is asked for every cell once, level after level in order.
  template <class IsDivided>
  void divide(const std::vector<std::uint64_t>& keys, IsDivided is_divided);

  OctreeDomain domain_;
  int depth_ = 0;
  std::vector<std::uint32_t> order_;
  std::array<std::vector<double>, 3> coordinates_;
  std::vector<std::vector<Cell>> levels_;
};

}  // namespace isostack
