#include "recon/solvers/box_tree.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <utility>

namespace isostack {

BoxTree::BoxTree(Eigen::MatrixXd points) : points_(std::move(points)) {
  const Eigen::Index n = points_.rows(), count = points_.cols();
  const Eigen::Index leaves = (count + leaf_size - 1) / leaf_size;
  levels_.emplace_back(2 * n, leaves);
  tbb::parallel_for(Eigen::Index{0}, leaves, [&](Eigen::Index leaf) {
    const auto block = points_.middleCols(leaf * leaf_size, std::min(leaf_size, count - leaf * leaf_size));
    levels_[0].col(leaf).head(n) = block.rowwise().minCoeff();
    levels_[0].col(leaf).tail(n) = block.rowwise().maxCoeff();
  });
  while (levels_.back().cols() > 2 * fan_out) {
    const Eigen::MatrixXd& finer = levels_.back();
    Eigen::MatrixXd coarser(2 * n, (finer.cols() + fan_out - 1) / fan_out);
    for (Eigen::Index box = 0; box < coarser.cols(); ++box) {
      const auto block = finer.middleCols(box * fan_out, std::min(fan_out, finer.cols() - box * fan_out));
      coarser.col(box).head(n) = block.topRows(n).rowwise().minCoeff();
      coarser.col(box).tail(n) = block.bottomRows(n).rowwise().maxCoeff();
    }
    levels_.push_back(std::move(coarser));
  }
}

std::vector<std::uint32_t> curve_order(const Eigen::MatrixXd& points) {
  const int dimension = static_cast<int>(points.rows()), bits = 60 / dimension;
  const Eigen::VectorXd low = points.rowwise().minCoeff();
  const double extent = (points.rowwise().maxCoeff() - low).maxCoeff();
  const double steps = static_cast<double>((std::uint64_t{1} << bits) - 1) / (extent > 0 ? extent : 1);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(static_cast<std::size_t>(points.cols()));
  tbb::parallel_for(std::size_t{0}, keyed.size(), [&](std::size_t i) {
    std::uint64_t key = 0;
    std::uint64_t place[6];
    for (int a = 0; a < dimension; ++a)
      place[a] = static_cast<std::uint64_t>((points(a, static_cast<Eigen::Index>(i)) - low[a]) * steps);
    for (int bit = bits - 1; bit >= 0; --bit)
      for (int a = 0; a < dimension; ++a) key = key << 1 | (place[a] >> bit & 1);
    keyed[i] = {key, static_cast<std::uint32_t>(i)};
  });
  tbb::parallel_sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> order(keyed.size());
  for (std::size_t k = 0; k < keyed.size(); ++k) order[k] = keyed[k].second;
  return order;
}

}  // namespace isostack
