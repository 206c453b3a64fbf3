#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/subdivision/level_operators.h"

namespace isostack {

/// The least bending of a displacement d with some vertices' displacements given:
/// E(d) = Σ counted ⁱ |(K d + load)ᵢ|² / mᵢ + η Σ mᵢ |dᵢ|².
struct BendingProblem {
  const LevelOperators& operators;
  Eigen::VectorXd counted;  ///< 1 for rows that count, 0 at the open ends, where the surface may lean as it likes
  Eigen::MatrixXd load;     ///< what bends already, one column per vertex
  double eta = 0;           ///< 1/length⁴: keeps what is displaced within about that length
  std::vector<char> fixed;  ///< of each vertex
};

struct BendingSolution {
  Eigen::MatrixXd displacement;
  double first_energy = 0, energy = 0;
  int iterations = 0;
  bool converged = true;
};

/// From `start`, whose fixed columns are the given displacements, by conjugate gradients, each step of which lowers E.
/// The tolerance is that of its gradient, relative to that at the start.
BendingSolution least_bending(const BendingProblem& problem, Eigen::MatrixXd start, double tolerance,
                              int most_iterations);

/// The same to rounding, by a factorisation: for surfaces, where it has little fill.
BendingSolution least_bending_factored(const BendingProblem& problem, Eigen::MatrixXd start);

}  // namespace isostack
