#pragma once

#include <Eigen/Core>
#include <memory>

#include "recon/constraints/contour_constraints.h"
#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "recon/reconstruct.h"
#include "recon/solvers/interpolation_solver.h"
#include "recon/surface/implicit_function.h"

namespace isostack {

/// The function of one organ while it is being fitted to its contours: solves settle the values of the
/// partners of obliquely cut contour points, planes that disagree add constraints. What comes before the last solve
/// only steers it and is solved loosely.
class ContourFit {
 public:
  /// All arguments must outlive this.
  ContourFit(const ContourStack& contours, const ReconstructOptions& options, const Progress& progress,
             ReconstructReport& report);

  /// The function after all rounds, solved to the tolerance. Throws SolveError as reconstruct() does.
  ImplicitFunction run();
  const ContourConstraints& constraints() const { return built_; }

 private:
  ImplicitFunction settle(int solves);
  ImplicitFunction solve(double tolerance_pixels);
  bool add_disagreements(const ImplicitFunction& function);

  const ContourStack& contours_;
  const ReconstructOptions& options_;
  const Progress& progress_;
  ReconstructReport& report_;
  double pixel_mm_;
  ContourConstraints built_;
  std::unique_ptr<InterpolationSolver> solver_;
  Eigen::VectorXd weights_;  ///< of the last solve; constraints added since are not among them
};

}  // namespace isostack
