#pragma once

#include <Eigen/Core>

#include "recon/geometry/slice.h"

namespace isostack {

/// Separable Gaussian low-pass filter (Breen et al. 2001, §4.3.1). `sigma_pixels` is the standard deviation
/// along x (columns) and y (rows) in pixels of that axis; 0 leaves the axis as it is. The kernel is
/// normalised, so constants stay; beyond the border the nearest pixel is repeated.
Image<float> gaussian_filter(const Image<float>& image, const Eigen::Vector2d& sigma_pixels);

/// The same with one sigma in mm along both axes of pixels spaced `spacing_mm` apart.
Image<float> gaussian_filter_mm(const Image<float>& image, double sigma_mm, const Eigen::Vector2d& spacing_mm);

}  // namespace isostack
