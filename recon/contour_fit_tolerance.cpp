// What ContourFit does to keep within a distance of the contours: more constraints, or smoothing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/constraints/refine_samples.h"
#include "recon/contour_fit.h"
#include "recon/geometry/errors.h"
#include "recon/largest_smoothing.h"
#include "recon/solve_steps.h"

namespace isostack {

namespace {

SolveError out_of_reach(const ContourResidual& reached, const ContourStack& contours, double tolerance_mm) {
  return {contours.name.empty() ? "contours" : contours.name,
          fmt::format("even the surface without smoothing is {:.3g} mm from the contours (in {}), not within {:g} mm",
                      reached.largest_mm, contours.slices[reached.worst_slice].name, tolerance_mm),
          "look for slices that contradict each other, keep more contour points with --max-constraints, or give a "
          "larger --tolerance"};
}

/// No smooth surface meets both contours where slices contradict each other by more than half a pixel.
void require_agreement(const Contradictions& contradictions, const std::string& name, double pixel_mm) {
  const double largest_mm = contradictions.largest_mismatch_mm();
  if (largest_mm <= 0.5 * pixel_mm) return;
  const auto worst = std::max_element(
      contradictions.pairs.begin(), contradictions.pairs.end(),
      [](const SlicePair& a, const SlicePair& b) { return a.largest_mismatch_mm < b.largest_mismatch_mm; });
  throw SolveError(name.empty() ? "contours" : name,
                   fmt::format("the contours of slices {} and {} miss each other by {:.3g} mm where they cross, so no "
                               "smooth surface passes through both",
                               worst->first_name, worst->second_name, largest_mm),
                   fmt::format("give --tolerance {:.2g} or more, or --interpolate to pass through both all the same",
                               largest_mm / 2 + 0.05));
}

}  // namespace

/// Adds the contour points farthest from the surface as constraints; false when all are near enough, no more are
/// allowed, or thinning was not asked for.
bool ContourFit::add_farthest(const ImplicitFunction& function) {
  const std::size_t most = options_.max_constraints / 3;
  if (options_.thin_mm <= 0 || samples_.size() >= most) return false;
  progress_.report("thinning", 0);
  double length_mm = 0;
  for (const ContourSlice& slice : contours_.slices)
    for (const Contour& contour : slice.contours) length_mm += perimeter_mm(contour);
  RefineOptions refine;
  refine.least_spacing_mm = 0.1 * pixel_mm_;
  refine.tolerance_mm = std::max(options_.thin_mm / 2, options_.thin_mm - 0.02 * pixel_mm_);
  refine.spread_mm = 0.5 * length_mm / static_cast<double>(samples_.size());
  refine.most = std::min(most - samples_.size(), std::max<std::size_t>(20, samples_.size() / 4));
  const Eigen::VectorXd distances = distances_to_zero_set_mm(function, positions_mm(contour_points_, contours_));
  const std::vector<ContourSample> farthest = farthest_samples(contour_points_, distances, samples_, refine);
  if (farthest.empty()) return false;
  samples_.insert(samples_.end(), farthest.begin(), farthest.end());
  build_constraints();
  correct_for_oblique_cuts(function.gradients(positions_mm(samples_, contours_)), contours_, built_);
  weights_.resize(0);  // partners have moved behind the new samples
  return true;
}

/// The same constraints, met as smoothly as the tolerance allows; the values of partners follow the surface.
ImplicitFunction ContourFit::smooth_to_tolerance(ImplicitFunction interpolating) {
  const double allowed_mm = *options_.tolerance_mm > 0 ? *options_.tolerance_mm : 0.25 * pixel_mm_;
  if (*options_.tolerance_mm == 0) require_agreement(report_.contradictions, contours_.name, pixel_mm_);
  const ContourResidual given = contour_residual(interpolating, contours_, contour_points_);
  if (given.largest_mm > allowed_mm) throw out_of_reach(given, contours_, *options_.tolerance_mm);
  if (*options_.tolerance_mm == 0) return solve(options_.solve_tolerance_pixels);

  ImplicitFunction smoothest = std::move(interpolating);
  const int power = options_.kernel.power;
  const auto largest_distance_mm = [&](double smoothing) {
    progress_.report("smoothing", 0);
    smoothing_ = smoothing;
    solver_.reset();
    solver_ = std::make_unique<InterpolationSolver>(smoothed_constraints(), interpolation_options(options_, pixel_mm_),
                                                    progress_);
    ImplicitFunction function = solve(options_.solve_tolerance_pixels);
    const double largest_mm = contour_residual(function, contours_, contour_points_).largest_mm;
    if (largest_mm <= allowed_mm) {
      smoothest = std::move(function);
      report_.smoothing = smoothing;
    }
    return largest_mm;
  };
  const Eigen::MatrixXd& points = built_.constraints.points;
  const double size_mm = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
  largest_smoothing_within(allowed_mm, {1e-3 * std::pow(pixel_mm_, power), 1e3 * std::pow(size_mm, power)},
                           largest_distance_mm);
  return smoothest;
}

void ContourFit::report_residual(const ImplicitFunction& function) {
  report_.contour_residual = contour_residual(function, contours_, contour_points_);
}

}  // namespace isostack
