#pragma once

#include <Eigen/Core>
#include <map>
#include <utility>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// A straight piece of a curve between two points, by their numbers.
struct LoopEdge {
  int from = 0, to = 0;
  int loop = 0;          ///< which curve
  std::size_t next = 0;  ///< index of the edge that follows in the curve
};

/// Curves as edges between shared points: points nearer than the tolerance are one.
class LoopEdges {
 public:
  LoopEdges(const std::vector<Contour>& contours, double tolerance_mm);

  /// Pairs of curves, maybe of a curve with itself, that cross, touch or run along each other.
  std::vector<std::pair<int, int>> meetings() const;

  /// Cuts edges where they cross and where a point of another lies on them. Afterwards they are no longer linked.
  void cut_where_they_meet();

  const std::vector<LoopEdge>& edges() const { return edges_; }
  const Eigen::Vector2d& at(int point) const { return points_[static_cast<std::size_t>(point)]; }

 private:
  int point_at(const Eigen::Vector2d& place);
  bool is_on(int point, const LoopEdge& edge) const;
  bool meet(const LoopEdge& a, const LoopEdge& b) const;
  template <class Visit>
  void for_each_close_pair(Visit visit) const;
  bool cut_once();

  double tolerance_mm_;
  std::vector<Eigen::Vector2d> points_;
  std::map<std::pair<long, long>, std::vector<int>> cells_;  ///< points by place; cells as wide as the tolerance
  std::vector<LoopEdge> edges_;
};

}  // namespace isostack
