#pragma once

#include <array>
#include <memory>
#include <vector>

#include "recon/solvers/sibling_groups.h"
#include "recon/solvers/translation_table.h"

namespace isostack {

/// How finely the far field is interpolated. The order grows towards coarse levels: the same
/// relative error of a larger cell is a larger absolute one, and coarse cells are few.
struct FarFieldOptions {
  int order = 6;            ///< interpolation nodes along an axis on the finest level
  double order_growth = 1;  ///< more nodes per level towards the root
  int most_order = 13;      ///< on any level
};
/// Nodes along an axis so many levels above the finest.
int order_at(const FarFieldOptions& options, int levels_above);

/// The sources' side of an interpolation-based fast multipole method: weights become values at
/// the nodes of every cell, and their spectra, by which translations between cells are products.
class SourceField {
 public:
  static constexpr int top_level = 2;  ///< above it no two cells are well separated

  struct Level {
    NodeGrid grid;
    GridDft dft;
    TranslationTable table;
    SiblingGroups groups;
    std::unique_ptr<double[]> multipoles;  ///< [group][node][lane]
    std::unique_ptr<double[]> spectra;     ///< [block][cell][real, imaginary]
    std::size_t group_doubles() const { return grid.node_count() * sibling_lanes; }
    std::size_t spectrum_doubles() const { return block_count(dft) * groups.group_of_cell.size() * block_doubles; }
  };

  /// The tree must outlive this.
  SourceField(const RadialFunction& function, const Octree& tree, const std::array<bool, 3>& flat,
              const FarFieldOptions& options);

  /// Prepares the translations that occur, unless they were prepared before.
  void prepare(const Interactions& interactions);
  /// Weights in the tree's order.
  void gather(const double* weights);

  const Octree& tree() const { return tree_; }
  int level_count() const { return static_cast<int>(levels_.size()); }
  const Level& level(int l) const { return levels_[static_cast<std::size_t>(l)]; }
  /// Between level l + 1 and l.
  const GridTransfer& transfer(int l) const { return transfers_[static_cast<std::size_t>(l)]; }
  std::size_t bytes() const;

 private:
  void gather_level(int l, const double* weights);
  void transform_level(int l);

  const Octree& tree_;
  std::vector<Level> levels_;
  std::vector<GridTransfer> transfers_;
};

}  // namespace isostack
