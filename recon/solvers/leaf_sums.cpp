#include "recon/solvers/leaf_sums.h"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "recon/solvers/sibling_groups.h"

namespace isostack {

namespace {

constexpr std::uint32_t most_points = 512;  ///< of a leaf in one task

/// Copies of a leaf's near sources, side by side and padded with zero weights.
struct NearSources {
  std::vector<double> x, y, z, w;

  void gather(const Octree& tree, const std::vector<double>& weights,
              std::span<const std::pair<std::uint32_t, std::uint32_t>> ranges) {
    x.clear(), y.clear(), z.clear(), w.clear();
    for (const auto& [first, last] : ranges) {
      append(tree.coordinates(0), first, last, x);
      append(tree.coordinates(1), first, last, y);
      append(tree.coordinates(2), first, last, z);
      append(weights, first, last, w);
    }
    const std::size_t count = (w.size() + source_padding - 1) / source_padding * source_padding;
    x.resize(count, 0.0), y.resize(count, 0.0), z.resize(count, 0.0), w.resize(count, 0.0);
  }

 private:
  static void append(const std::vector<double>& from, std::uint32_t first, std::uint32_t last,
                     std::vector<double>& to) {
    to.insert(to.end(), from.begin() + first, from.begin() + last);
  }
};

/// Points of one leaf.
struct LeafTask {
  int level;
  std::uint32_t cell, first, last;
};

std::vector<LeafTask> leaf_tasks(const Octree& targets) {
  std::vector<LeafTask> tasks;
  for (int l = 0; l < targets.level_count(); ++l)
    for (std::uint32_t c = 0; c < targets.level(l).size(); ++c) {
      const Octree::Cell& cell = targets.level(l)[c];
      if (!cell.leaf()) continue;
      for (std::uint32_t first = cell.first; first < cell.last; first += most_points)
        tasks.push_back({l, c, first, std::min(first + most_points, cell.last)});
    }
  return tasks;
}

std::size_t column_count(Derivatives derivatives) {
  return derivatives == Derivatives::none ? 1 : derivatives == Derivatives::first ? 4 : 10;
}

/// The sums of one task, one padded column each: value, gradient, Hessian.
SumArrays cleared_columns(std::vector<double>& columns, std::size_t column_count) {
  columns.assign(column_count * most_points, 0.0);
  const auto column = [&](std::size_t k) { return columns.data() + k * most_points; };
  SumArrays arrays;
  arrays.value = column(0);
  for (std::size_t a = 0; a < 3 && column_count > 1; ++a) arrays.gradient[a] = column(1 + a);
  for (std::size_t a = 0; a < 6 && column_count > 4; ++a) arrays.hessian[a] = column(4 + a);
  return arrays;
}

void store(const SumArrays& sums, const LeafTask& task, const Octree& targets, RadialSums& result) {
  for (std::uint32_t k = task.first; k < task.last; ++k) {
    const auto i = static_cast<Eigen::Index>(targets.order()[k]);
    const std::uint32_t at = k - task.first;
    result.values[i] = sums.value[at];
    for (Eigen::Index a = 0; a < result.gradients.rows(); ++a) result.gradients(a, i) = sums.gradient[a][at];
    for (Eigen::Index a = 0; a < result.hessians.rows(); ++a) result.hessians(a, i) = sums.hessian[a][at];
  }
}

}  // namespace

RadialSums sum_at_leaves(const RadialFunction& function, const Octree& sources, const std::vector<double>& weights,
                         const Octree& targets, const std::function<LeafTerms(int, std::uint32_t)>& terms_of,
                         Eigen::Index dimension, Derivatives derivatives) {
  const auto count = static_cast<Eigen::Index>(targets.point_count());
  RadialSums result;
  result.values.resize(count);
  if (derivatives != Derivatives::none) result.gradients.resize(dimension, count);
  if (derivatives == Derivatives::second) result.hessians.resize(6, count);

  struct Scratch {
    NearSources near;
    std::vector<double> columns;
  };
  tbb::enumerable_thread_specific<Scratch> scratch;
  const std::vector<LeafTask> tasks = leaf_tasks(targets);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tasks.size()), [&](const auto& range) {
    Scratch& own = scratch.local();
    for (std::size_t t = range.begin(); t < range.end(); ++t) {
      const LeafTask& task = tasks[t];
      const LeafTerms terms = terms_of(task.level, task.cell);
      const PointArrays points = points_between(targets, task.first, task.last);
      const SumArrays sums = cleared_columns(own.columns, column_count(derivatives));
      if (terms.grid)
        add_expansion_at_points(*terms.grid, cell_frame(targets, task.level, task.cell), terms.far, points, sums);
      own.near.gather(sources, weights, terms.near);
      const NearSources& near = own.near;
      add_near_sums(function, {near.x.data(), near.y.data(), near.z.data(), near.w.size()}, near.w.data(), points,
                    sums);
      store(sums, task, targets, result);
    }
  });
  return result;
}

}  // namespace isostack
