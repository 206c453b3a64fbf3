#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "recon/subdivision/simplex_subdivision.h"

namespace isostack {

/// A mesh's connectivity at the levels 0 (the base) to K. Vertices of a level keep their numbers at the next.
struct SubdivisionLevels {
  Eigen::Index base_vertex_count = 0;
  Eigen::MatrixXi base;                   ///< simplices of level 0
  std::vector<SimplexSubdivision> steps;  ///< [k] leads from level k to k + 1

  int finest() const { return static_cast<int>(steps.size()); }
  const Eigen::MatrixXi& simplices(int level) const;
  Eigen::Index vertex_count(int level) const;
};

SubdivisionLevels subdivision_levels(const Eigen::MatrixXi& base, Eigen::Index vertex_count, int levels);

/// Where a vertex of some level lies in its base simplex: base vertices and their weights, which sum to 1.
struct BasePlace {
  std::array<int, 4> vertex = {-1, -1, -1, -1};  ///< ascending; unused ones are -1
  std::array<double, 4> weight = {};
};

/// Of all vertices of the finest level (of coarser ones, the first).
std::vector<BasePlace> base_places(const SubdivisionLevels& levels);

/// A chain of vertices of level `from` with the vertices that halve its edges, at level `to`. Neighbours in the chain
/// must be joined by edges.
std::vector<int> refined_chain(std::vector<int> chain, const SubdivisionLevels& levels, int from, int to);

}  // namespace isostack
