#include "recon/solvers/leaf_sums.h"

#include <oneapi/tbb/parallel_for.h>

namespace isostack {

namespace {

/// Copies of a leaf's near sources, side by side and padded with zero weights.
struct NearSources {
  std::vector<double> x, y, z, w;

  void clear() { x.clear(), y.clear(), z.clear(), w.clear(); }
  void append(const Octree& tree, const std::vector<double>& weights, std::uint32_t first, std::uint32_t last) {
    const auto copy = [&](const std::vector<double>& from, std::vector<double>& to) {
      to.insert(to.end(), from.begin() + first, from.begin() + last);
    };
    copy(tree.coordinates(0), x), copy(tree.coordinates(1), y), copy(tree.coordinates(2), z), copy(weights, w);
  }
  void pad() {
    const std::size_t count = (w.size() + source_padding - 1) / source_padding * source_padding;
    x.resize(count, 0.0), y.resize(count, 0.0), z.resize(count, 0.0), w.resize(count, 0.0);
  }
};

/// Results in tree order, one column each: value, gradient, Hessian.
SumArrays columns_of(Eigen::MatrixXd& results) {
  SumArrays arrays;
  arrays.value = results.col(0).data();
  for (int a = 0; a < 3 && results.cols() > 1; ++a) arrays.gradient[a] = results.col(1 + a).data();
  for (int a = 0; a < 6 && results.cols() > 4; ++a) arrays.hessian[a] = results.col(4 + a).data();
  return arrays;
}

RadialSums in_original_order(const Eigen::MatrixXd& results, const Octree& targets, Eigen::Index dimension) {
  const Eigen::Index count = results.rows();
  RadialSums sums;
  sums.values.resize(count);
  if (results.cols() > 1) sums.gradients.resize(dimension, count);
  if (results.cols() > 4) sums.hessians.resize(6, count);
  tbb::parallel_for(tbb::blocked_range<Eigen::Index>(0, count, 4096), [&](const auto& range) {
    for (Eigen::Index k = range.begin(); k < range.end(); ++k) {
      const auto i = static_cast<Eigen::Index>(targets.order()[static_cast<std::size_t>(k)]);
      sums.values[i] = results(k, 0);
      for (Eigen::Index a = 0; a < sums.gradients.rows(); ++a) sums.gradients(a, i) = results(k, 1 + a);
      for (Eigen::Index a = 0; a < sums.hessians.rows(); ++a) sums.hessians(a, i) = results(k, 4 + a);
    }
  });
  return sums;
}

}  // namespace

RadialSums sum_at_leaves(const RadialFunction& function, const SourceField& sources, const TargetField& far,
                         const Octree& targets, const Interactions& interactions, const std::vector<double>& weights,
                         Eigen::Index dimension, Derivatives derivatives) {
  const Eigen::Index columns = derivatives == Derivatives::none ? 1 : derivatives == Derivatives::first ? 4 : 10;
  Eigen::MatrixXd results = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(targets.point_count()), columns);
  const SumArrays arrays = columns_of(results);
  for (int l = 0; l < targets.level_count(); ++l) {
    const auto& cells = targets.level(l);
    const Interactions::Level& lists = interactions.levels[static_cast<std::size_t>(l)];
    tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(cells.size()), [&](std::uint32_t c) {
      if (!cells[c].leaf()) return;
      const SumArrays sums = arrays.from(cells[c].first);
      far.add_at_leaf(sources, l, c, sums);
      thread_local NearSources near;
      near.clear();
      for (std::uint32_t k = lists.near_begin[c]; k < lists.near_begin[c + 1]; ++k)
        near.append(sources.tree(), weights, lists.near[k].first, lists.near[k].second);
      near.pad();
      add_near_sums(function, {near.x.data(), near.y.data(), near.z.data(), near.w.size()}, near.w.data(),
                    points_of(targets, cells[c]), sums);
    });
  }
  return in_original_order(results, targets, dimension);
}

}  // namespace isostack
