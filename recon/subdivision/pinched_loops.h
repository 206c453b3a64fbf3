#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

namespace isostack {

/// How many outer loops and holes there are.
struct LoopCount {
  int outer = 0, holes = 0;
  bool operator==(const LoopCount&) const = default;
};

/// Directed loops, the inside to their left, that touch at pinches: the places where a morph's parts join or split. A
/// pinch is passed twice; the two passes can be joined the other way round ("switched"), which makes one loop of two or
/// two of one and leaves the inside to the left.
struct PinchedLoops {
  std::vector<Eigen::Vector2d> places_mm;    ///< of the passes
  std::vector<int> next;                     ///< pass that follows, as the loops are given
  std::vector<std::pair<int, int>> pinches;  ///< passes at one place

  /// The passes of each loop, in order, with some pinches switched.
  std::vector<std::vector<int>> loops(const std::vector<bool>& switched) const;
  LoopCount count(const std::vector<bool>& switched) const;
  double signed_area_mm2(const std::vector<int>& loop) const;

  void add(const std::vector<Eigen::Vector2d>& loop);
};

/// Loops that touch where points of two of them, or of one, are nearer than the tolerance. Throws InputError when more
/// than two meet in a point.
PinchedLoops pinched_loops(const std::vector<std::vector<Eigen::Vector2d>>& loops, double tolerance_mm);

/// Loops tied together into one, by pinches half-way between the nearest points of neighbours.
PinchedLoops tied_together(const std::vector<std::vector<Eigen::Vector2d>>& loops);

/// Which pinches to switch so that there are as many outer loops and holes as wanted, or nearly; as few as can be.
/// Throws InputError for more than 12 pinches.
std::vector<bool> switched_for(const PinchedLoops& loops, const LoopCount& wanted);

}  // namespace isostack
