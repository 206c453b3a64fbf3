// What ContourFit does so that sections of the surface by the input planes give the contours back.
#include <algorithm>
#include <cmath>

#include "recon/constraints/refine_samples.h"
#include "recon/contour_fit.h"

namespace isostack {

namespace {

/// The sample of `candidates` nearest to the point; -1 where there is none.
Eigen::Index nearest_sample(const std::vector<ContourSample>& samples, const std::vector<std::size_t>& candidates,
                            const Eigen::Vector2d& point_in_slice_mm) {
  Eigen::Index nearest = -1;
  double least = 0;
  for (const std::size_t i : candidates) {
    const double distance = (samples[i].point_in_slice_mm - point_in_slice_mm).squaredNorm();
    if (nearest < 0 || distance < least) least = distance, nearest = static_cast<Eigen::Index>(i);
  }
  return nearest;
}

}  // namespace

bool ContourFit::add(const SectionDeviations& deviations, const ImplicitFunction& function) {
  const std::size_t samples_before = samples_.size(), strays_before = strays_.size();
  const std::size_t allowed = options_.max_constraints / 3 + options_.max_constraints / 12;  // repairs come on top
  RefineOptions refine;
  refine.tolerance_mm = 0;
  refine.spread_mm = 0.5 * pixel_mm_;
  refine.least_spacing_mm = 0.2 * pixel_mm_;
  refine.most = allowed - std::min(allowed, samples_.size());
  const std::vector<ContourSample> missed =
      farthest_samples(deviations.missed,
                       Eigen::Map<const Eigen::VectorXd>(deviations.missed_by_mm.data(),
                                                         static_cast<Eigen::Index>(deviations.missed_by_mm.size())),
                       samples_, refine);
  samples_.insert(samples_.end(), missed.begin(), missed.end());
  std::vector<StrayPoint> strays = deviations.stray;
  std::erase_if(strays, [&](const StrayPoint& stray) {
    return is_explained_by(soft_places_, contours_.slices[stray.slice].pose.slice_to_world(stray.point_in_slice_mm),
                           stray.distance_mm, options_.softening);
  });
  strays = farthest_strays(std::move(strays), 0.5 * pixel_mm_, allowed - std::min(allowed, strays_.size()));
  strays_.insert(strays_.end(), strays.begin(), strays.end());
  if (samples_.size() == samples_before && strays_.size() == strays_before) return false;

  build_constraints();
  correct_for_oblique_cuts(function.gradients(positions_mm(samples_, contours_)), contours_, built_);
  if (samples_.size() > samples_before) weights_.resize(0);  // partners have moved behind the new samples
  report_.section_constraints = samples_.size() - report_.boundary_constraints + strays_.size();
  return true;
}

ImplicitFunction ContourFit::run_again() {
  std::optional<ImplicitFunction> function = settle(1);
  if (options_.solve_tolerance_pixels < loose_tolerance_pixels) {
    function.reset();
    function = solve(options_.solve_tolerance_pixels);
  }
  report_residual(*function);
  solver_.reset();
  return std::move(*function);
}

/// What keeps the section from straying: values as far as a pixel says, corrected for oblique cuts as partners are.
void ContourFit::add_strays() {
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<double> values_mm;
  const Eigen::Index before = built_.constraints.values.size();
  std::vector<std::vector<std::size_t>> samples_on(contours_.slices.size());
  for (std::size_t i = 0; i < samples_.size(); ++i) samples_on[samples_[i].slice].push_back(i);
  for (const StrayPoint& stray : strays_) {
    const double value_mm = std::clamp(stray.distance_mm, -pixel_mm_, pixel_mm_);
    const Eigen::Index sample = nearest_sample(samples_, samples_on[stray.slice], stray.point_in_slice_mm);
    if (sample >= 0)
      built_.partners.push_back({before + static_cast<Eigen::Index>(points_mm.size()), sample, value_mm});
    points_mm.push_back(contours_.slices[stray.slice].pose.slice_to_world(stray.point_in_slice_mm));
    values_mm.push_back(value_mm);
  }
  add_points(points_mm, values_mm, built_);
}

}  // namespace isostack
