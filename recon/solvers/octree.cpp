#include "recon/solvers/octree.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace isostack {

namespace {

constexpr int deepest_level = 20;

std::uint64_t spread_bits(std::uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x1f00000000ffffULL;
  v = (v | v << 16) & 0x1f0000ff0000ffULL;
  v = (v | v << 8) & 0x100f00f00f00f00fULL;
  v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
  return (v | v << 2) & 0x1249249249249249ULL;
}

/// Orders the cells of one level along the Morton curve.
std::uint64_t place_key(const std::array<int, 3>& place) {
  std::uint64_t key = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    key |= spread_bits(static_cast<std::uint64_t>(place[axis])) << (2 - axis);
  return key;
}

/// Level above which two keys share their cell.
int common_level(std::uint64_t a, std::uint64_t b) {
  return a == b ? deepest_level : (3 * deepest_level - static_cast<int>(std::bit_width(a ^ b))) / 3;
}

/// A level and how far its leaves are from holding `leaf_size` points on average, as a factor ≥ 1.
struct Fit {
  int depth = 0;
  double mismatch = 0;
};

/// The level (≥ 2) that fits best.
Fit common_depth(const std::vector<std::uint64_t>& keys, int leaf_size) {
  std::array<std::size_t, deepest_level + 1> splits{};
  for (std::size_t k = 1; k < keys.size(); ++k) ++splits[static_cast<std::size_t>(common_level(keys[k - 1], keys[k]))];
  Fit best;
  std::size_t cells = 1;
  for (int level = 0; level < deepest_level; ++level) {
    const double ratio = static_cast<double>(keys.size()) / static_cast<double>(cells) / leaf_size;
    const double mismatch = std::max(ratio, 1 / ratio);
    if (level >= 2 && (best.depth == 0 || mismatch < best.mismatch)) best = {level, mismatch};
    cells += splits[static_cast<std::size_t>(level)];
  }
  return best;
}

/// Sorted Morton keys of the points with their columns.
std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted_keys(const Eigen::MatrixXd& points,
                                                                 const OctreeDomain& domain) {
  const double cells = static_cast<double>(1 << deepest_level);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(static_cast<std::size_t>(points.cols()));
  tbb::parallel_for(std::size_t{0}, keyed.size(), [&](std::size_t i) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double x = axis < points.rows() ? points(axis, static_cast<Eigen::Index>(i)) - domain.centre[axis] : 0;
      const double cell = std::clamp((x / domain.width + 0.5) * cells, 0.0, cells - 1);
      key |= spread_bits(static_cast<std::uint64_t>(cell)) << (2 - axis);
    }
    keyed[i] = {key, static_cast<std::uint32_t>(i)};
  });
  tbb::parallel_sort(keyed.begin(), keyed.end());
  return keyed;
}

}  // namespace

OctreeDomain OctreeDomain::around(const Eigen::MatrixXd& points, double margin) {
  OctreeDomain domain;
  const Eigen::VectorXd low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
  domain.centre.head(points.rows()) = (low + high) / 2;
  const double extent = (high - low).maxCoeff();
  domain.width = extent > 0 ? extent * (1 + margin) : 1;
  return domain;
}

OctreeDomain OctreeDomain::fitted(const Eigen::MatrixXd& points, double margin, int leaf_size) {
  const OctreeDomain tight = around(points, margin);
  OctreeDomain best = tight;
  double least = std::numeric_limits<double>::infinity();
  for (const double widening : {1.0, 1.2, 1.45, 1.7}) {
    OctreeDomain domain = tight;
    domain.width *= widening;
    const auto keyed = sorted_keys(points, domain);
    std::vector<std::uint64_t> keys;
    for (const auto& [key, column] : keyed) keys.push_back(key);
    const double mismatch = common_depth(keys, leaf_size).mismatch;
    if (mismatch >= least) continue;
    least = mismatch;
    best = domain;
  }
  return best;
}

bool OctreeDomain::contains(const Eigen::Ref<const Eigen::VectorXd>& point) const {
  return ((point - centre.head(point.size())).cwiseAbs().array() <= width / 2).all();
}

Octree::Octree(const Eigen::MatrixXd& points, const OctreeDomain& domain, int leaf_size, int depth, int deepest)
    : domain_(domain) {
  const std::vector<std::uint64_t> keys = sort_points(points);
  depth_ = depth >= 0 ? depth : common_depth(keys, leaf_size).depth;
  const auto crowd = static_cast<std::uint32_t>(4 * leaf_size);
  divide(keys, [&](int l, const Cell& cell) {
    return l < std::min(deepest, deepest_level) && (l < depth_ || cell.count() > crowd);
  });
}

Octree::Octree(const Eigen::MatrixXd& points, const Octree& like) : domain_(like.domain_), depth_(like.depth_) {
  const std::vector<std::uint64_t> keys = sort_points(points);
  // Both trees list their cells along the same curve, so the cell alike is found by walking on.
  int walked_level = -1;
  std::size_t walked = 0;
  divide(keys, [&](int l, const Cell& cell) {
    if (l < depth_) return true;
    if (l >= like.level_count()) return false;
    if (l != walked_level) walked_level = l, walked = 0;
    const auto& others = like.level(l);
    const std::uint64_t key = place_key(cell.place);
    while (walked < others.size() && place_key(others[walked].place) < key) ++walked;
    return walked < others.size() && others[walked].place == cell.place && !others[walked].leaf();
  });
}

std::vector<std::uint64_t> Octree::sort_points(const Eigen::MatrixXd& points) {
  const auto count = static_cast<std::size_t>(points.cols());
  const auto keyed = sorted_keys(points, domain_);
  order_.resize(count);
  for (auto& axis : coordinates_) axis.assign(count, 0.0);
  std::vector<std::uint64_t> keys(count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const auto& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      keys[k] = keyed[k].first;
      order_[k] = keyed[k].second;
      for (int axis = 0; axis < static_cast<int>(points.rows()); ++axis)
        coordinates_[static_cast<std::size_t>(axis)][k] = points(axis, order_[k]) - domain_.centre[axis];
    }
  });
  return keys;
}

template <class IsDivided>
void Octree::divide(const std::vector<std::uint64_t>& keys, IsDivided is_divided) {
  levels_.assign(1, {Cell{{0, 0, 0}, 0, static_cast<std::uint32_t>(keys.size()), 0, 0, 0}});
  for (int l = 0; l < deepest_level; ++l) {
    std::vector<Cell> children;
    const int shift = 3 * (deepest_level - l - 1);
    auto& cells = levels_.back();
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
      Cell& cell = cells[c];
      cell.first_child = cell.last_child = static_cast<std::uint32_t>(children.size());
      if (!is_divided(l, cell)) continue;
      for (std::uint32_t first = cell.first; first < cell.last;) {
        const std::uint64_t prefix = keys[first] >> shift;
        const auto end = std::partition_point(keys.begin() + first, keys.begin() + cell.last,
                                              [&](std::uint64_t key) { return key >> shift <= prefix; });
        const auto last = static_cast<std::uint32_t>(end - keys.begin());
        std::array<int, 3> place = cell.place;
        for (int axis = 0; axis < 3; ++axis)
          place[static_cast<std::size_t>(axis)] =
              2 * place[static_cast<std::size_t>(axis)] + static_cast<int>(prefix >> (2 - axis) & 1);
        children.push_back({place, first, last, 0, 0, c});
        first = last;
      }
      cell.last_child = static_cast<std::uint32_t>(children.size());
    }
    if (children.empty()) break;
    levels_.push_back(std::move(children));
  }
}

Eigen::Vector3d Octree::cell_centre(int l, const Cell& cell) const {
  Eigen::Vector3d centre;
  for (int axis = 0; axis < 3; ++axis)
    centre[axis] = (cell.place[static_cast<std::size_t>(axis)] + 0.5) * cell_width(l) - domain_.width / 2;
  return centre;
}

}  // namespace isostack
