#include "recon/contour_fit.h"

#include <algorithm>
#include <limits>

#include "recon/constraints/plane_check.h"
#include "recon/constraints/refine_samples.h"
#include "recon/solve_steps.h"

namespace isostack {

namespace {

double pixel_mm_of(const ContourStack& contours) {
  double pixel_mm = std::numeric_limits<double>::infinity();
  for (const ContourSlice& slice : contours.slices) pixel_mm = std::min(pixel_mm, slice.pose.spacing_mm.minCoeff());
  return pixel_mm;
}

/// How many contour points to start from: as many as may be kept, or few when thinning adds what is missing.
std::size_t first_samples(const ContourStack& contours, const ReconstructOptions& options) {
  const std::size_t most = options.max_constraints / 3;
  if (options.thin_mm <= 0) return most;
  std::size_t count = 0;
  for (const ContourSlice& slice : contours.slices) count += slice.contours.size();
  return std::min(most, std::max(8 * count, point_count(contours) / 20));
}

}  // namespace

ContourFit::ContourFit(const ContourStack& contours, const ReconstructOptions& options, const Progress& progress,
                       ReconstructReport& report)
    : contours_(contours),
      options_(options),
      progress_(progress),
      report_(report),
      pixel_mm_(pixel_mm_of(contours)),
      smoothing_(options.smoothing),
      samples_(sample_contours(contours, {.max_samples = first_samples(contours, options),
                                          .min_spacing_pixels = options.sample_spacing_pixels})),
      contour_points_(all_samples(contours)) {
  thin_places_ = thin_between(contours);
  build_constraints();
  report.smoothing = options.smoothing;
  report.contradictions = find_contradictions(contours);
  if (options.softening.strength > 0 && !options.tolerance_mm)  // a tolerance decides by itself how much to smooth
    soft_places_ = soft_places(report.contradictions, pixel_mm_, options.softening);
}

ImplicitFunction ContourFit::run() {
  const double tolerance = options_.solve_tolerance_pixels, loose = std::max(tolerance, loose_tolerance_pixels);
  std::optional<ImplicitFunction> function = settle(options_.solves);
  const auto settle_again = [&](int solves) {
    function.reset();  // its memory is the next solve's
    function = settle(solves);
  };
  while (add_farthest(*function)) settle_again(2);
  std::vector<Disagreement> wrong = disagreements(*function);
  for (int round = 0; round < options_.plane_check_rounds && !wrong.empty(); ++round) {
    add(wrong);
    settle_again(std::min(options_.solves, 2));
    wrong = disagreements(*function);
  }
  while (add_farthest(*function)) settle_again(2);
  if (options_.tolerance_mm) {
    function = smooth_to_tolerance(std::move(*function));
  } else if (loose > tolerance) {
    function.reset();
    function = solve(tolerance);
  }
  report_residual(*function);
  solver_.reset();  // its memory is the surface's
  return std::move(*function);
}

/// Solves for the constraints as they are, then again with the partners' values corrected by the
/// normals found, `solves` times in all. Only values change: one solver serves all solves.
ImplicitFunction ContourFit::settle(int solves) {
  solver_.reset();  // before the next one takes as much memory again
  solver_ = std::make_unique<InterpolationSolver>(smoothed_constraints(), interpolation_options(options_, pixel_mm_),
                                                  progress_);
  describe(*solver_, static_cast<std::size_t>(built_.constraints.values.size()), report_);
  const Eigen::MatrixXd boundary = built_.constraints.points.leftCols(static_cast<Eigen::Index>(built_.samples.size()));
  const double loose = std::max(options_.solve_tolerance_pixels, loose_tolerance_pixels);
  for (int done = 1; done < solves; ++done) {
    const Eigen::MatrixXd gradients = solve(loose).gradients(boundary);
    progress_.report("normals", static_cast<double>(done) / solves);
    correct_for_oblique_cuts(gradients, contours_, built_);
  }
  return solve(loose);
}

/// Smoothing as asked for, and as much as crossing slices' contradictions need.
ConstraintSet ContourFit::smoothed_constraints() {
  ConstraintSet set = with_smoothing(built_.constraints, smoothing_);
  if (soft_places_.empty()) return set;
  const Eigen::VectorXd softening = softening_of(set.points, soft_places_, options_.kernel, options_.softening);
  report_.softened_constraints = static_cast<std::size_t>((softening.array() > 0).count());
  set.smoothing = set.smoothing.size() > 0 ? softening.cwiseMax(smoothing_).eval() : softening;
  return set;
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

/// Where f has the wrong sign on a plane, but for what is softened because planes contradict each other.
std::vector<Disagreement> ContourFit::disagreements(const ImplicitFunction& function) {
  progress_.report("planes", 0);
  PlaneCheck check = check_planes([&](const Eigen::MatrixXd& points) { return function.values(points); }, contours_);
  report_.plane_points = check.points;
  report_.plane_points_wrong = check.wrong;
  std::erase_if(check.worst, [&](const Disagreement& d) {
    return is_explained_by(soft_places_, d.point_mm, d.distance_mm, options_.softening);
  });
  const std::vector<Disagreement> lost = lost_between(function);
  report_.between_points_wrong = check.wrong_between + lost.size();
  check.worst.insert(check.worst.end(), lost.begin(), lost.end());
  return std::move(check.worst);
}

/// Thin parts that neighbouring slices share, where f has lost or swollen them on the way from one to the other.
std::vector<Disagreement> ContourFit::lost_between(const ImplicitFunction& function) {
  Eigen::MatrixXd points(3, static_cast<Eigen::Index>(thin_places_.size()));
  for (std::size_t i = 0; i < thin_places_.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = thin_places_[i].point_mm;
  const Eigen::VectorXd values = function.values(points);
  std::vector<Disagreement> lost;
  for (std::size_t i = 0; i < thin_places_.size(); ++i) {
    const ThinPlace& place = thin_places_[i];
    if ((values[static_cast<Eigen::Index>(i)] > 0) != (place.distance_mm > 0))
      lost.push_back({place.slice, place.point_mm, place.distance_mm});
  }
  return lost;
}

void ContourFit::add(const std::vector<Disagreement>& wrong) {
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<double> values_mm;
  for (const Disagreement& d : wrong) {
    points_mm.push_back(d.point_mm);
    values_mm.push_back(d.distance_mm);
  }
  add_points(points_mm, values_mm, built_);
  added_points_mm_.insert(added_points_mm_.end(), points_mm.begin(), points_mm.end());
  added_values_mm_.insert(added_values_mm_.end(), values_mm.begin(), values_mm.end());
  report_.plane_constraints += points_mm.size();
}

void ContourFit::build_constraints() {
  built_ = signed_constraints(contours_, samples_, {.offset_pixels = options_.offset_pixels});
  add_points(added_points_mm_, added_values_mm_, built_);
  add_strays();
}

}  // namespace isostack
