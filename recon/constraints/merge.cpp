#include "recon/constraints/merge.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isostack {

namespace {

/// Places along a direction that no slice, axis or diagonal is perpendicular to, so that few points
/// share a place. No two points are farther apart there than they are.
Eigen::VectorXd places_along_skew_line(const Eigen::MatrixXd& points) {
  const Eigen::VectorXd direction =
      Eigen::VectorXd::NullaryExpr(points.rows(), [](Eigen::Index axis) { return 1 / std::sqrt(2.0 + 3.7 * axis); });
  return (points.colwise() - points.col(0)).transpose() * direction.normalized();
}

/// Representative of each point: the first in its group. Points are swept along a line, where only neighbours within
/// the tolerance are compared.
std::vector<Eigen::Index> representatives(const Eigen::MatrixXd& points, double tolerance) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(points.cols()));
  if (order.empty()) return {};
  const Eigen::VectorXd place = places_along_skew_line(points);
  const double reach = tolerance + 1e-14 * (place.maxCoeff() - place.minCoeff());  // rounding of the places
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index a, Eigen::Index b) { return place[a] != place[b] ? place[a] < place[b] : a < b; });
  std::vector<Eigen::Index> representative(order.size()), first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Eigen::Index here = order[i];
    Eigen::Index& mine = representative[static_cast<std::size_t>(here)] = here;
    for (std::size_t j = i; j-- > 0 && place[here] - place[order[j]] <= reach;) {
      const Eigen::Index other = representative[static_cast<std::size_t>(order[j])];
      if ((points.col(here) - points.col(other)).norm() > tolerance) continue;
      mine = other;
      break;
    }
  }
  // Points added to a set later never displace the earlier ones.
  std::iota(first.begin(), first.end(), Eigen::Index{0});
  for (std::size_t i = order.size(); i-- > 0;)
    first[static_cast<std::size_t>(representative[i])] = static_cast<Eigen::Index>(i);
  for (Eigen::Index& one : representative) one = first[static_cast<std::size_t>(one)];
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
