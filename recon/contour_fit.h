#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "recon/constraints/contour_constraints.h"
#include "recon/constraints/contour_samples.h"
#include "recon/constraints/plane_check.h"
#include "recon/constraints/thin_between.h"
#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "recon/reconstruct.h"
#include "recon/section_repairs.h"
#include "recon/solvers/interpolation_solver.h"
#include "recon/surface/implicit_function.h"

namespace isostack {

/// Normals and planes' disagreements need no more.
constexpr double loose_tolerance_pixels = 0.02;

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

  /// Adds constraints where sections of the surface strayed from the contours; false when nothing could be added.
  /// `function` is the last one.
  bool add(const SectionDeviations& deviations, const ImplicitFunction& function);

  /// The function with what add() added. The last one is not needed: without it there is room for the solve.
  ImplicitFunction run_again();

  const ContourConstraints& constraints() const { return built_; }

 private:
  ImplicitFunction settle(int solves);
  ImplicitFunction solve(double tolerance_pixels);
  std::vector<Disagreement> disagreements(const ImplicitFunction& function);
  std::vector<Disagreement> lost_between(const ImplicitFunction& function);
  void add(const std::vector<Disagreement>& wrong);
  ConstraintSet smoothed_constraints();
  void build_constraints();
  bool add_farthest(const ImplicitFunction& function);
  ImplicitFunction smooth_to_tolerance(ImplicitFunction interpolating);
  void add_strays();
  void report_residual(const ImplicitFunction& function);

  const ContourStack& contours_;
  const ReconstructOptions& options_;
  const Progress& progress_;
  ReconstructReport& report_;
  double pixel_mm_;
  double smoothing_;
  std::vector<ContourSample> samples_;            ///< contour points that are constraints
  std::vector<ContourSample> contour_points_;     ///< all of them
  std::vector<Eigen::Vector3d> added_points_mm_;  ///< what planes objected to
  std::vector<double> added_values_mm_;
  std::vector<StrayPoint> strays_;  ///< where sections of the surface were off the contours
  std::vector<SoftPlace> soft_places_;
  std::vector<ThinPlace> thin_places_;  ///< between slices
  ContourConstraints built_;
  std::unique_ptr<InterpolationSolver> solver_;
  Eigen::VectorXd weights_;  ///< of the last solve; constraints added since are not among them
};

}  // namespace isostack
