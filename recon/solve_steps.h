#pragma once

#include <cstddef>
#include <string>

#include "recon/reconstruct.h"
#include "recon/solvers/interpolation_solver.h"

namespace isostack {

/// The solver's options for a reconstruction whose finest pixels are `pixel_mm` wide.
InterpolationOptions interpolation_options(const ReconstructOptions& options, double pixel_mm);

/// The constraints with the same smoothing for each.
ConstraintSet with_smoothing(ConstraintSet set, double smoothing);

/// What a solver is about to solve, for `given` constraints.
void describe(const InterpolationSolver& solver, std::size_t given, ReconstructReport& report);

/// What a solve did. Throws SolveError (naming `name`) when it stalled and that is not accepted.
void describe(const SolveReport& solve, const std::string& name, const ReconstructOptions& options,
              ReconstructReport& report);

}  // namespace isostack
