#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "recon/solvers/expansions.h"
#include "recon/solvers/octree.h"
#include "recon/solvers/radial_sums.h"

namespace isostack {

/// All that acts on the points of one target leaf.
struct LeafTerms {
  const NodeGrid* grid = nullptr;  ///< null: there is no far field
  ExpansionView far;
  std::span<const std::pair<std::uint32_t, std::uint32_t>> near;  ///< ranges of sources, first to last
};

/// Everything at the leaves: the far field and the near sources' terms, in the targets' own order.
/// `weights` are in the source tree's order; `terms_of(level, cell)` is asked once per leaf, from any thread.
RadialSums sum_at_leaves(const RadialFunction& function, const Octree& sources, const std::vector<double>& weights,
                         const Octree& targets, const std::function<LeafTerms(int, std::uint32_t)>& terms_of,
                         Eigen::Index dimension, Derivatives derivatives);

}  // namespace isostack
