#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "recon/geometry/slice.h"
#include "segmentation/components.h"
#include "segmentation/threshold.h"

namespace isostack {

/// A point within an organ.
struct Seed {
  Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();  ///< world LPS
  std::string name = {};  ///< seeds of one name belong to one organ; "-": something that is not wanted, but must be
                          ///< told apart from the organs
};

/// The pixel a seed falls on.
struct SeedPixel {
  std::size_t slice;  ///< index into the stack
  Eigen::Index row, column;
};

/// "seed 10,20,30 (liver)", for messages.
std::string seed_text(const Seed& seed);

/// The pixel of the nearest slice at the seed. Throws InputError when it is beside the image, or farther from every
/// slice than half the distance between neighbours.
SeedPixel pixel_of(const Seed& seed, const SliceStack& stack);

/// Mean ± `spread` standard deviations of what surrounds the seed in its slice's (filtered) grey values: of the box of
/// 4 mm (at least 2 pixels) to each side at first, then three times of what is connected to it within the range and 10
/// mm (at least 3 pixels). Throws InputError naming the slice when its image is constant.
GreyRange range_like_seed(const Slice& slice, const Image<float>& grey, const SeedPixel& seed, double spread);

}  // namespace isostack
