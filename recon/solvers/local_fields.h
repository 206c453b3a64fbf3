#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

#include "recon/solvers/leaf_sums.h"
#include "recon/solvers/source_field.h"

namespace isostack {

/// The far fields and near sources of target leaves, computed when points first come there and kept:
/// later points in the same places cost only their own terms. For trees divided like the sources'
/// (Octree's second constructor). May be used from several threads at once.
class LocalFields {
 public:
  /// `sources` have gathered their weights and outlive this. Everything is forgotten once it exceeds `kept_bytes`.
  LocalFields(SourceField& sources, std::size_t kept_bytes) : sources_(sources), kept_bytes_(kept_bytes) {}

  struct Leaf {
    std::vector<double> far;  ///< at the nodes of the level's grid
    std::vector<std::pair<std::uint32_t, std::uint32_t>> near;
  };
  /// [level][cell]; null where the cell is no leaf.
  using Leaves = std::vector<std::vector<std::shared_ptr<const Leaf>>>;
  Leaves at(const Octree& targets);

 private:
  void compute(const Octree& cells);

  SourceField& sources_;
  std::size_t kept_bytes_;
  std::mutex mutex_;  ///< of everything below, and of the sources' preparation
  std::unordered_map<std::uint64_t, std::shared_ptr<const Leaf>> leaves_;
  std::size_t bytes_ = 0;
};

}  // namespace isostack
