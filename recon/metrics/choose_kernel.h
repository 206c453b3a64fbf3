#pragma once

#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "recon/metrics/slice_agreement.h"
#include "recon/reconstruct.h"

namespace isostack {

/// A kernel and a smoothing, and how well they predict slices left out.
struct KernelTrial {
  Kernel kernel;
  double smoothing = 0;  ///< ρ of every constraint
  SliceAgreement agreement;
};

/// Leaves every second slice out and predicts it from the others with each candidate: r³ and r³ with ρ = one pixel
/// cubed, r² log r, r, and r with ρ = a tenth of a pixel. The smallest mean distance to the dropped slices' contours
/// comes first; what ties keeps that order. At most 12,000 constraints are used. `options` give the rest. Throws
/// InputError for fewer than three slices, and when no dropped slice has a contour on both sides to compare.
std::vector<KernelTrial> try_kernels(const ContourStack& contours, const ReconstructOptions& options,
                                     const Progress& progress = {});

}  // namespace isostack
