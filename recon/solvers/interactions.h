#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "recon/solvers/octree.h"

namespace isostack {

/// Which cells of two octrees over the same domain act on each other through expansions, and
/// which directly. Every pair (target, source) of points is covered exactly once.
struct Interactions {
  static constexpr int offset_count = 343;  ///< places of a source cell, −3…3 along each axis
  static int offset_index(const std::array<int, 3>& target, const std::array<int, 3>& source) {
    return ((source[0] - target[0] + 3) * 7 + source[1] - target[1] + 3) * 7 + source[2] - target[2] + 3;
  }

  /// A well-separated source cell of the same level.
  struct Far {
    std::uint32_t offset;  ///< offset_index
    std::uint32_t source;  ///< index into the source tree's level
  };
  /// Per level, the far cells of target cell c are far[far_begin[c]] … far[far_begin[c + 1]).
  struct Level {
    std::vector<std::uint32_t> far_begin;
    std::vector<Far> far;
    /// For leaves: ranges of source points (tree order) summed directly; empty for other cells.
    std::vector<std::uint32_t> near_begin;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> near;

    std::span<const std::pair<std::uint32_t, std::uint32_t>> near_of(std::uint32_t cell) const {
      return {near.data() + near_begin[cell], near.data() + near_begin[cell + 1]};
    }
  };
  std::vector<Level> levels;

  double near_pairs = 0, far_pairs = 0;  ///< the work: point pairs and cell pairs

  Interactions(const Octree& targets, const Octree& sources);
};

}  // namespace isostack
