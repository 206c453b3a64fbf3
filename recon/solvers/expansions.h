#pragma once

#include "recon/solvers/near_sum.h"
#include "recon/solvers/node_grid.h"

namespace isostack {

/// Where a cell lies: its centre and half its width, in the coordinates of the points.
struct CellFrame {
  double centre[3];
  double half_width;
};

/// Adds the points' weights to the cell's nodes (points to multipole). `expansion` is the cell's lane
/// of a sibling group: node q at expansion[q · sibling_lanes].
void add_points_to_expansion(const NodeGrid& grid, const CellFrame& frame, const PointArrays& points,
                             const double* weights, double* expansion);

/// Adds the interpolated field (and its derivatives, as far as `sums` has room) at the points.
void add_expansion_at_points(const NodeGrid& grid, const CellFrame& frame, const double* expansion,
                             const PointArrays& points, const SumArrays& sums);

/// Adds eight siblings' nodes to one lane of their parent's group.
void add_siblings_to_parent(const GridTransfer& transfer, const double* siblings, double* parent);

/// Adds the parent's field (one lane of its group) to all eight lanes of its children's group.
void add_parent_to_siblings(const GridTransfer& transfer, const double* parent, double* siblings);

}  // namespace isostack
