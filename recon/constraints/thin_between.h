#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

struct ThinBetweenOptions {
  double least_gap_pixels = 2;        ///< between slices; nothing thin hides in less
  double step_pixels = 4;             ///< along the normal, at most; half-way at least is looked at
  double least_overlap_pixels = 0.1;  ///< how far inside both slices have to show a place
  double clear_pixels = 0.5;          ///< how far outside both have to show one beside it
};

/// A place between two neighbouring parallel slices in the middle of a thin part that both show, or just beside it.
struct ThinPlace {
  std::size_t slice;  ///< the lower of the two
  Eigen::Vector3d point_mm;
  double distance_mm;  ///< interpolated from the two slices' signed distances, positive inside
};

/// Where a sheet or strand is thinner than the slices are apart, samples on the slices alone leave it to the kernel
/// whether it lasts from one to the next; r³ makes islands of it. Where the slices overlap it does last: places along
/// the crest of what both show as inside, one in two by two pixels and as far inside as half the gap at most, and to
/// both sides of it the nearest places, within four pixels, that both show as outside. Thin gaps are left to the
/// kernel.
std::vector<ThinPlace> thin_between(const ContourStack& stack, const ThinBetweenOptions& options = {});

}  // namespace isostack
