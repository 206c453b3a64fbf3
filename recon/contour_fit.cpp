#include "recon/contour_fit.h"

#include <algorithm>
#include <limits>

#include "recon/constraints/plane_check.h"
#include "recon/solve_steps.h"

namespace isostack {

namespace {

/// Normals and planes' disagreements need no more.
constexpr double loose_tolerance_pixels = 0.02;

double pixel_mm_of(const ContourStack& contours) {
  double pixel_mm = std::numeric_limits<double>::infinity();
  for (const ContourSlice& slice : contours.slices) pixel_mm = std::min(pixel_mm, slice.pose.spacing_mm.minCoeff());
  return pixel_mm;
}

}  // namespace

ContourFit::ContourFit(const ContourStack& contours, const ReconstructOptions& options, const Progress& progress,
                       ReconstructReport& report)
    : contours_(contours),
      options_(options),
      progress_(progress),
      report_(report),
      pixel_mm_(pixel_mm_of(contours)),
      built_(signed_constraints(contours, sample_contours(contours, {.max_samples = options.max_constraints / 3}),
                                {.offset_pixels = options.offset_pixels})) {}

ImplicitFunction ContourFit::run() {
  const double tolerance = options_.solve_tolerance_pixels, loose = std::max(tolerance, loose_tolerance_pixels);
  ImplicitFunction function = settle(options_.solves);
  for (int round = 0; round < options_.plane_check_rounds && add_disagreements(function); ++round)
    function = settle(std::min(options_.solves, 3));
  return loose > tolerance ? solve(tolerance) : std::move(function);
}

/// Solves for the constraints as they are, then again with the partners' values corrected by the
/// normals found, `solves` times in all. Only values change: one solver serves all solves.
ImplicitFunction ContourFit::settle(int solves) {
  solver_ = std::make_unique<InterpolationSolver>(with_smoothing(built_.constraints, options_.smoothing),
                                                  interpolation_options(options_, pixel_mm_), progress_);
  describe(*solver_, static_cast<std::size_t>(built_.constraints.values.size()), report_);
  const Eigen::MatrixXd boundary = built_.constraints.points.leftCols(static_cast<Eigen::Index>(built_.samples.size()));
  const double loose = std::max(options_.solve_tolerance_pixels, loose_tolerance_pixels);
  ImplicitFunction function = solve(loose);
  for (int done = 1; done < solves; ++done) {
    progress_.report("normals", static_cast<double>(done) / solves);
    correct_for_oblique_cuts(function.gradients(boundary), contours_, built_);
    function = solve(loose);
  }
  return function;
}

ImplicitFunction ContourFit::solve(double tolerance_pixels) {
  ++report_.solves;
  SolveReport reached;
  solver_->set_tolerance(tolerance_pixels * pixel_mm_);
  const RadialWeights solution = solver_->solve(built_.constraints.values, weights_, reached, progress_);
  describe(reached, contours_.name, options_, report_);
  weights_ = solution.weights;
  return ImplicitFunction(options_.kernel, solver_->merged().set.points, solution, tolerance_pixels * pixel_mm_);
}

/// Adds what the planes object to; false when they all agree.
bool ContourFit::add_disagreements(const ImplicitFunction& function) {
  progress_.report("planes", 0);
  const PlaneCheck check =
      check_planes([&](const Eigen::MatrixXd& points) { return function.values(points); }, contours_);
  report_.plane_points = check.points;
  report_.plane_points_wrong = check.wrong;
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<double> values_mm;
  for (const Disagreement& d : check.worst) {
    points_mm.push_back(d.point_mm);
    values_mm.push_back(d.distance_mm);
  }
  add_points(points_mm, values_mm, built_);
  report_.plane_constraints += points_mm.size();
  return !check.worst.empty();
}

}  // namespace isostack
