#pragma once

#include <string>
#include <vector>

#include "recon/geometry/slice.h"
#include "segmentation/threshold.h"

namespace isostack {

/// Throws InputError naming the slice: no slices, no pixels, pixels that are not finite, spacing that is not positive.
void require_segmentable(const SliceStack& stack);

/// Throws InputError when no pixel is in the range or all are; suggests a level between the darker and the brighter
/// ones. `depths` = depth_in_range() of the (filtered) images.
void require_crossing(const std::string& stack_name, const std::vector<Image<float>>& images, const GreyRange& range,
                      const std::vector<Image<float>>& depths);

}  // namespace isostack
