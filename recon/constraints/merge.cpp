#include "recon/constraints/merge.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isostack {

namespace {

/// Representative of each point: itself or an earlier point within the tolerance. Points are
/// swept along the first axis, where only neighbours within the tolerance are compared.
std::vector<Eigen::Index> representatives(const Eigen::MatrixXd& points, double tolerance) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(points.cols()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    for (Eigen::Index axis = 0; axis < points.rows(); ++axis)
      if (points(axis, a) != points(axis, b)) return points(axis, a) < points(axis, b);
    return a < b;
  });
  std::vector<Eigen::Index> representative(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Eigen::Index here = order[i];
    representative[static_cast<std::size_t>(here)] = here;
    for (std::size_t j = i; j-- > 0 && points(0, here) - points(0, order[j]) <= tolerance;) {
      const Eigen::Index other = representative[static_cast<std::size_t>(order[j])];
      if ((points.col(here) - points.col(other)).norm() > tolerance) continue;
      representative[static_cast<std::size_t>(here)] = other;
      break;
    }
  }
  return representative;
}

}  // namespace

Eigen::VectorXd MergedConstraints::merged(const Eigen::VectorXd& original_values) const {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(set.points.cols()), counts = sums;
  for (std::size_t i = 0; i < group_of.size(); ++i) {
    sums[group_of[i]] += original_values[static_cast<Eigen::Index>(i)];
    counts[group_of[i]] += 1;
  }
  return sums.cwiseQuotient(counts);
}

MergedConstraints merge_coinciding(const ConstraintSet& constraints, double tolerance) {
  const std::vector<Eigen::Index> representative = representatives(constraints.points, tolerance);
  MergedConstraints result;
  result.group_of.resize(representative.size());
  std::vector<Eigen::Index> kept;
  for (std::size_t i = 0; i < representative.size(); ++i) {
    if (representative[i] != static_cast<Eigen::Index>(i)) continue;
    result.group_of[i] = static_cast<Eigen::Index>(kept.size());
    kept.push_back(static_cast<Eigen::Index>(i));
  }
  for (std::size_t i = 0; i < representative.size(); ++i)
    result.group_of[i] = result.group_of[static_cast<std::size_t>(representative[i])];

  result.set.points = constraints.points(Eigen::all, kept);
  result.set.values = result.merged(constraints.values);
  if (constraints.smoothing.size() > 0) result.set.smoothing = constraints.smoothing(kept);
  for (std::size_t i = 0; i < representative.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const double difference = std::abs(constraints.values[column] - constraints.values[representative[i]]);
    result.largest_contradiction = std::max(result.largest_contradiction, difference);
    if (constraints.smoothing.size() > 0)
      result.set.smoothing[result.group_of[i]] =
          std::min(result.set.smoothing[result.group_of[i]], constraints.smoothing[column]);
  }
  return result;
}

}  // namespace isostack
