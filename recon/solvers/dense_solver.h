#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/kernels/kernel.h"
#include "recon/solvers/radial_weights.h"

namespace isostack {

/// The linear system of Turk & O'Brien 1999, eq. 3, solved directly; the reference for the fast
/// solver. The weights live in the subspace that annihilates the tail's polynomials, where
/// sign · φ is positive definite: two-sided Householder reflections lead there and a Cholesky
/// factorisation solves. Factor once, solve for many right-hand sides.
class DenseSolver {
 public:
  struct Options {
    std::size_t memory_limit_bytes = std::size_t{8} << 30;
  };

  /// Points are n × N, distinct; smoothing is empty or one ρ ≥ 0 per point (0 interpolates).
  /// Throws SolveError when the memory limit is too small or points coincide.
  DenseSolver(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& smoothing,
              const Options& options, const Progress& progress = {});

  /// One value per point; (φ + sign·ρ) weights + tail = values.
  RadialWeights solve(const Eigen::VectorXd& values) const;

  static std::size_t required_bytes(std::size_t constraint_count);

 private:
  Eigen::Index tail_rank() const { return reflectors_.cols(); }
  void factorise(const Progress& progress);
  Eigen::VectorXd times_system(const Eigen::VectorXd& weights) const;
  Eigen::VectorXd reflect_into_subspace(const Eigen::VectorXd& vector) const;  ///< Qᵀ v
  Eigen::VectorXd reflect_back(const Eigen::VectorXd& vector) const;           ///< Q v

  Kernel kernel_;
  Eigen::MatrixXd points_;
  Eigen::VectorXd smoothing_;
  PolynomialBasis tail_;
  Eigen::MatrixXd tail_values_;     ///< N × rank, the independent monomials at the points
  std::vector<Eigen::Index> kept_;  ///< which monomials those are
  Eigen::MatrixXd reflectors_;      ///< N × rank, V of Q = I − V T Vᵀ
  Eigen::MatrixXd triangle_;        ///< rank × rank, T
  Eigen::MatrixXd factor_;          ///< N × N; its lower right block holds the Cholesky factor
};

}  // namespace isostack
