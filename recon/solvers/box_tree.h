#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isostack {

/// Points of any dimension in an order in which neighbours in the list tend to be neighbours in
/// space (a space-filling curve), under a pyramid of bounding boxes. Quick to build, and fast for
/// the range queries around points of the same list.
class BoxTree {
 public:
  /// `points` is n × M.
  explicit BoxTree(Eigen::MatrixXd points);

  Eigen::Index size() const { return points_.cols(); }
  const Eigen::MatrixXd& points() const { return points_; }

  struct Neighbour {
    double squared_distance;
    std::uint32_t index;
    bool operator<(const Neighbour& other) const {
      return squared_distance < other.squared_distance ||
             (squared_distance == other.squared_distance && index < other.index);
    }
  };
  /// Appends every point within `radius` of `centre` for which accept(index) holds.
  template <class Accept>
  void within(const Eigen::Ref<const Eigen::VectorXd>& centre, double radius, std::vector<Neighbour>& found,
              Accept accept) const;

 private:
  static constexpr Eigen::Index leaf_size = 8, fan_out = 4;
  double squared_distance_to_box(std::size_t level, Eigen::Index box, const double* centre) const;

  Eigen::MatrixXd points_;
  /// levels_[0] holds a box per leaf (2n × boxes: low over high), each next one a box per `fan_out`.
  std::vector<Eigen::MatrixXd> levels_;
};

inline double BoxTree::squared_distance_to_box(std::size_t level, Eigen::Index box, const double* centre) const {
  const Eigen::Index n = points_.rows();
  const double* low = levels_[level].data() + box * 2 * n;
  double sum = 0;
  for (Eigen::Index a = 0; a < n; ++a) {
    const double outside = std::max(0.0, std::max(low[a] - centre[a], centre[a] - low[n + a]));
    sum += outside * outside;
  }
  return sum;
}

template <class Accept>
void BoxTree::within(const Eigen::Ref<const Eigen::VectorXd>& centre, double radius, std::vector<Neighbour>& found,
                     Accept accept) const {
  const double limit = radius * radius;
  const double* c = centre.data();
  const Eigen::Index n = points_.rows();
  struct Entry {
    std::size_t level;
    Eigen::Index box;
  };
  Entry stack[256];
  std::size_t depth = 0;
  for (Eigen::Index box = 0; box < levels_.back().cols(); ++box) stack[depth++] = {levels_.size() - 1, box};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (squared_distance_to_box(entry.level, entry.box, c) > limit) continue;
    if (entry.level > 0) {
      const Eigen::Index last = std::min((entry.box + 1) * fan_out, levels_[entry.level - 1].cols());
      for (Eigen::Index box = entry.box * fan_out; box < last; ++box) stack[depth++] = {entry.level - 1, box};
      continue;
    }
    const Eigen::Index last = std::min((entry.box + 1) * leaf_size, points_.cols());
    for (Eigen::Index i = entry.box * leaf_size; i < last; ++i) {
      const double* p = points_.data() + i * n;
      double squared = 0;
      for (Eigen::Index a = 0; a < n; ++a) squared += (p[a] - c[a]) * (p[a] - c[a]);
      if (squared <= limit && accept(static_cast<std::uint32_t>(i)))
        found.push_back({squared, static_cast<std::uint32_t>(i)});
    }
  }
}

/// An order of points (n × N) along a space-filling curve: the columns in that order.
std::vector<std::uint32_t> curve_order(const Eigen::MatrixXd& points);

}  // namespace isostack
