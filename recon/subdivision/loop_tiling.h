#pragma once

#include <Eigen/Core>
#include <set>
#include <utility>
#include <vector>

namespace isostack {

/// A place of one loop joined with one of another by an edge: (lower, upper).
using LoopPair = std::pair<int, int>;

struct TilingRules {
  std::vector<LoopPair> joined = {};   ///< edges that must be there, in cyclic order
  std::set<LoopPair> not_joined = {};  ///< edges that must not
};

/// Triangles between two loops, as their edges from the lower to the upper loop, once round: each next edge shares one
/// end with the former and has the next place of the other loop at its other end. The sum of their squared lengths is
/// the least there is (closest pairs, both loops' centres put on each other) of tilings that join the first place of
/// the lower loop with one of the 64 nearest ones. Throws InputError when the edges that must be there cross.
std::vector<LoopPair> tile_loops(const std::vector<Eigen::Vector2d>& lower, const std::vector<Eigen::Vector2d>& upper,
                                 const TilingRules& rules);

}  // namespace isostack
