#pragma once

#include <cstddef>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/morphing/key_places.h"
#include "recon/morphing/morph.h"
#include "recon/morphing/shape.h"
#include "recon/morphing/signed_distance_stack.h"

namespace isostack {

struct SignedDistanceMorphOptions {
  KeyLayout layout = KeyLayout::line;
  AlongNormal between = AlongNormal::linear;  ///< cubic: a spline through all key shapes of a line
  /// Of the frames: lattice of figures, grid of bodies. 0: a pixel, or a hundredth of the box's longest side.
  double resolution_mm = 0;
  std::size_t memory_limit_bytes = std::size_t{4} << 30;  ///< of the distance grids of bodies
};

/// The baseline: frames are where the weighted mean of the key shapes' signed distances is positive (Herman et al.
/// 1992; the paper's Figure 3, top). Distances are exact: of figures everywhere, of bodies at the nodes of a grid.
/// On a line the two neighbouring key shapes count, or, cubic, all; elsewhere all by their weights.
/// Throws InputError for shapes that do not fit together, SolveError when grids do not fit into memory.
Morph signed_distance_morph(const std::vector<KeyShape>& shapes, const SignedDistanceMorphOptions& options,
                            const Progress& progress = {});

}  // namespace isostack
