#pragma once

#include <Eigen/Core>

#include "recon/geometry/slice.h"

namespace isostack {

struct DiffusionOptions {
  double contrast = 0;  ///< K: grey steps between neighbouring pixels well above it stay, those below are smoothed; > 0
  int steps = 10;       ///< each smooths flat regions like a Gaussian of about 0.7 pixel
};

/// Anisotropic diffusion I_t = ∇·(g(|∇I|) ∇I), g(s) = 1/(1 + (s/K)²) (Perona and Malik 1990, eq. 7): noise goes, edges
/// stay. Explicit steps at the stability limit, fluxes between 4-neighbours, none across the border, so that the mean
/// grey value stays. Spacings may differ between x and y: s is the step per smaller pixel spacing.
Image<float> anisotropic_diffusion(const Image<float>& image, const Eigen::Vector2d& spacing_mm,
                                   const DiffusionOptions& options);

}  // namespace isostack
