#pragma once

#include <Eigen/Core>

namespace isostack {

/// How a level of fit_multiresolution() went. Energy: of bending (see BendingProblem). Residual: the largest distance
/// of a vertex from the place that it is held at or that a constraint asks for, mm. The first are those of the former
/// level's surface, with what is held put in its place.
struct FitLevelReport {
  Eigen::Index vertices = 0;
  double first_energy = 0, energy = 0;
  double first_residual_mm = 0, residual_mm = 0;
  int iterations = 0;
  bool converged = true;
};

}  // namespace isostack
