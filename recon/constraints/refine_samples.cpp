#include "recon/constraints/refine_samples.h"

#include <algorithm>
#include <limits>

namespace isostack {

namespace {

bool is_near(const ContourSample& candidate, const std::vector<ContourSample>& samples, double distance_mm) {
  return std::any_of(samples.begin(), samples.end(), [&](const ContourSample& s) {
    return s.slice == candidate.slice && (s.point_in_slice_mm - candidate.point_in_slice_mm).norm() < distance_mm;
  });
}

}  // namespace

std::vector<ContourSample> all_samples(const ContourStack& contours) {
  return sample_contours(contours, {.max_samples = std::numeric_limits<std::size_t>::max(), .min_spacing_pixels = 0});
}

std::vector<ContourSample> farthest_samples(const std::vector<ContourSample>& candidates,
                                            const Eigen::VectorXd& distances_mm,
                                            const std::vector<ContourSample>& present, const RefineOptions& options) {
  std::vector<Eigen::Index> order;
  for (Eigen::Index i = 0; i < distances_mm.size(); ++i)
    if (!(distances_mm[i] <= options.tolerance_mm)) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return distances_mm[a] > distances_mm[b]; });
  std::vector<ContourSample> chosen;
  for (const Eigen::Index i : order) {
    if (chosen.size() == options.most) break;
    const ContourSample& candidate = candidates[static_cast<std::size_t>(i)];
    if (!is_near(candidate, chosen, options.spread_mm) && !is_near(candidate, present, options.least_spacing_mm))
      chosen.push_back(candidate);
  }
  return chosen;
}

}  // namespace isostack
