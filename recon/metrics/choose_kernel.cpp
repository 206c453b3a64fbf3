#include "recon/metrics/choose_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/geometry/errors.h"
#include "recon/metrics/leave_out.h"

namespace isostack {

namespace {

constexpr std::size_t most_constraints = 12'000;

std::vector<KernelTrial> candidates(const ContourStack& contours) {
  double pixel_mm = std::numeric_limits<double>::infinity();
  for (const ContourSlice& slice : contours.slices) pixel_mm = std::min(pixel_mm, slice.pose.spacing_mm.minCoeff());
  return {{triharmonic(), 0, {}},
          {triharmonic(), std::pow(pixel_mm, 3), {}},
          {thin_plate(), 0, {}},
          {biharmonic(), 0, {}},
          {biharmonic(), 0.1 * pixel_mm, {}}};
}

}  // namespace

std::vector<KernelTrial> try_kernels(const ContourStack& contours, const ReconstructOptions& options,
                                     const Progress& progress) {
  const SliceSplit split = split_slices(contours, 2);
  std::vector<KernelTrial> trials = candidates(contours);
  for (KernelTrial& trial : trials) {
    ReconstructOptions tried = options;
    tried.kernel = trial.kernel;
    tried.smoothing = trial.smoothing;
    tried.max_constraints = std::min(options.max_constraints, most_constraints);
    tried.accept_residual = true;  // a candidate that stalls just predicts badly
    ReconstructReport report;
    trial.agreement = agreement_on_dropped(contours, split, tried, report, progress);
  }
  std::erase_if(trials, [](const KernelTrial& trial) { return !trial.agreement.has_distances; });
  if (trials.empty())
    throw InputError(contours.name.empty() ? "contours" : contours.name,
                     "no slice left out has a contour to compare kernels by", "give --kernel by name");
  std::stable_sort(trials.begin(), trials.end(), [](const KernelTrial& a, const KernelTrial& b) {
    return a.agreement.mean_mm < b.agreement.mean_mm;
  });
  return trials;
}

}  // namespace isostack
