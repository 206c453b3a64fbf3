#pragma once

#include <cstdint>
#include <vector>

#include "recon/geometry/slice.h"

namespace isostack {

/// Grey values drawn as black and as white, in the images' units (HU for CT). Window = high - low, level = their mean.
struct GreyWindow {
  float low = 0;
  float high = 1;

  bool operator==(const GreyWindow&) const = default;
};

GreyWindow grey_window_from(double window, double level);

/// From the 0.1 % to the 99.9 % quantile of all finite pixels, as 3D Slicer chooses; of large stacks, of a sample
/// spread evenly over their pixels.
GreyWindow automatic_grey_window(const std::vector<const Image<float>*>& images);

/// 0 (low and below, and not finite) to 255 (high and above), as the image's pixels.
Image<std::uint8_t> grey_levels(const Image<float>& pixels, const GreyWindow& window);

}  // namespace isostack
