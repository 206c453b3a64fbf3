#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/kernels/kernel.h"
#include "recon/morphing/key_places.h"
#include "recon/morphing/morph.h"
#include "recon/morphing/shape.h"
#include "recon/solvers/interpolation_solver.h"

namespace isostack {

/// What constraints a shape gives.
enum class MorphRecipe {
  signed_distance,  ///< 0 on the boundary, partners inside and outside whose values are distances in mm
  turk_obrien       ///< the paper's: 0 on the boundary and 1 a little inside (§4.1 for figures, §4.2 for bodies)
};

struct VariationalMorphOptions {
  MorphRecipe recipe = MorphRecipe::signed_distance;
  Kernel kernel = triharmonic();
  KeyLayout layout = KeyLayout::line;
  /// Mean distance between neighbouring key shapes in the extra dimensions (§6.2): small is local, only features that
  /// lie close together stay; large is global, and frames of r³ swell. Unset: half the longest side of the
  /// box round all shapes, of bodies a quarter.
  std::optional<double> spacing_mm = {};
  double offset_pixels = 1;              ///< figures: distance of the partners, less where a part or a gap is thin
  double offset_fraction = 0.01;         ///< bodies: the same, in longest sides of the shape's box (the paper's k)
  double sample_spacing_pixels = 0.5;    ///< figures: nearer boundary points are left out
  std::size_t max_constraints = 20'000;  ///< of all key shapes together
  double smoothing = 0;                  ///< ρ of every constraint; 0 interpolates
  SolverChoice solver = SolverChoice::automatic;
  double solve_tolerance_pixels = 1e-3;  ///< largest residual of the fast solver; bodies: in thousandths of the box
  /// Of the frames: lattice of figures, cells of bodies. 0: a pixel, or a hundredth of the box's longest side.
  double resolution_mm = 0;
  std::size_t memory_limit_bytes = std::size_t{8} << 30;
};

/// One function of the shapes' n coordinates and m more (one on a line, one fewer than the key shapes on a simplex),
/// solved once through all key shapes' constraints (Turk & O'Brien 1999, §5 and §7); frames are its sections.
/// n + m is at most 6. Throws InputError for shapes that do not fit together, SolveError when the solve fails or
/// does not fit into memory.
Morph variational_morph(const std::vector<KeyShape>& shapes, const VariationalMorphOptions& options,
                        const Progress& progress = {});

}  // namespace isostack
