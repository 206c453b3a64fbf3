#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace isostack {

/// Things numbered from 0 that are joined into sets.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// The number that stands for the set of this thing.
  std::size_t root(std::size_t thing) {
    while (parent_[thing] != thing) thing = parent_[thing] = parent_[parent_[thing]];
    return thing;
  }
  /// root(b) stands for both sets from now on.
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace isostack
