#pragma once

#include <cstddef>
#include <vector>

#include "recon/solvers/near_sum.h"
#include "recon/solvers/node_grid.h"

namespace isostack {

/// Where a cell lies: its centre and half its width, in the coordinates of the points.
struct CellFrame {
  double centre[3];
  double half_width;
};

/// A cell's field at its nodes: node q at values[q · stride].
struct ExpansionView {
  const double* values = nullptr;
  std::size_t stride = 1;
};

/// Working memory of the transfers between levels, to be kept by the caller per thread.
struct TransferScratch {
  std::vector<double> carried, halfway, spread;
};

/// Adds the points' weights to the cell's nodes (points to multipole). `expansion` is the cell's lane
/// of a sibling group: node q at expansion[q · sibling_lanes].
void add_points_to_expansion(const NodeGrid& grid, const CellFrame& frame, const PointArrays& points,
                             const double* weights, double* expansion);

/// Adds the interpolated field (and its derivatives, as far as `sums` has room) at the points.
void add_expansion_at_points(const NodeGrid& grid, const CellFrame& frame, const ExpansionView& expansion,
                             const PointArrays& points, const SumArrays& sums);

/// Adds eight siblings' nodes to one lane of their parent's group.
void add_siblings_to_parent(const GridTransfer& transfer, const double* siblings, double* parent,
                            TransferScratch& scratch);

/// Adds the parent's field (one lane of its group) to all eight lanes of its children's group.
void add_parent_to_siblings(const GridTransfer& transfer, const double* parent, double* siblings,
                            TransferScratch& scratch);

}  // namespace isostack
