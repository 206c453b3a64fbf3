#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// A contour point kept as a boundary constraint.
struct ContourSample {
  std::size_t slice = 0;    ///< index into the stack
  std::size_t contour = 0;  ///< index into the slice's contours
  Eigen::Vector2d point_in_slice_mm;
  Eigen::Vector2d inward;  ///< unit normal in slice coordinates, towards the organ
};

struct ContourSamplingOptions {
  std::size_t max_samples = 4000;
  double min_spacing_pixels = 0.75;  ///< nearer contour points say nothing new
};

/// Contour points, thinned to at most max_samples: dense where a contour curves (spacing grows
/// with the square root of its radius, so that chords deviate equally), some points on every
/// contour. All samples are points of the given contours. Throws SolveError when there are more
/// contours than max_samples / 3.
std::vector<ContourSample> sample_contours(const ContourStack& stack, const ContourSamplingOptions& options);

}  // namespace isostack
