#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "recon/constraints/constraint_set.h"
#include "recon/constraints/merge.h"
#include "recon/solvers/dense_solver.h"
#include "recon/solvers/fast_solver.h"

namespace isostack {

enum class SolverChoice { automatic, dense, fast };

struct InterpolationOptions {
  Kernel kernel = triharmonic();
  SolverChoice solver = SolverChoice::automatic;  ///< automatic: fast from 8,000 constraints on
  double tolerance = 1e-4;                        ///< largest residual, in the values' units
  double merge_distance = 0;                      ///< points nearer than this, or than 1e-7 of their extent, become one
  std::size_t memory_limit_bytes = std::size_t{8} << 30;
};

/// What the last solve reached.
struct SolveReport {
  std::string solver;           ///< "dense" or "fast"
  double tolerance = 0;         ///< residual asked for, in the values' units
  double largest_residual = 0;  ///< reached, by direct sums (fast: at a sample of the constraints)
  bool converged = true;
  int iterations = 0, sweeps = 0;  ///< of conjugate gradients, and between corrections; 0 when dense
  std::string remark;              ///< where and why, when it did not converge
  std::size_t predicted_bytes = 0;
  /// Time and memory. Building the solver is among the stages of its first solve.
  std::vector<SolveStage> stages;
};

/// Solves one set of constraints, whose values may change from solve to solve, by the dense or
/// the fast solver. Coinciding points are merged before.
class InterpolationSolver {
 public:
  /// Throws InputError for constraints that are not finite, SolveError when the solve would not fit into
  /// memory or the system is singular.
  InterpolationSolver(const ConstraintSet& constraints, const InterpolationOptions& options,
                      const Progress& progress = {});

  /// One value per constraint as given. Each solve starts from the last one's solution; `start` (or
  /// an empty vector) serves the first: weights at the leading merged points.
  RadialWeights solve(const Eigen::VectorXd& values, const Eigen::VectorXd& start, SolveReport& report,
                      const Progress& progress = {});

  /// Of the solves that follow, in the values' units.
  void set_tolerance(double tolerance);

  const MergedConstraints& merged() const { return merged_; }
  std::size_t predicted_bytes() const;
  /// The same before anything is made, for points that do not coincide (n × N).
  static std::size_t required_bytes(const Eigen::MatrixXd& points, const InterpolationOptions& options);
  static bool uses_fast(SolverChoice choice, std::size_t constraint_count);

 private:
  RadialWeights solve_dense(const Eigen::VectorXd& values, SolveReport& report) const;
  RadialWeights solve_fast(const Eigen::VectorXd& values, const Eigen::VectorXd& start, SolveReport& report,
                           const Progress& progress);

  InterpolationOptions options_;
  MergedConstraints merged_;
  std::unique_ptr<DenseSolver> dense_;
  std::unique_ptr<FastSolver> fast_;
  std::vector<SolveStage> unreported_;  ///< stages of building, until a solve has reported them
  bool built_is_reported_ = false;
  Eigen::VectorXd last_weights_;
};

}  // namespace isostack
