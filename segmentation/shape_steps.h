#pragma once

#include <vector>

#include "recon/geometry/slice.h"
#include "segmentation/start_steps.h"

namespace isostack {

/// Applies a filter step to one image; other steps leave it alone.
void apply_filter(const StartStep& step, const Eigen::Vector2d& spacing_mm, Image<float>& grey);

/// Applies a step that needs nothing but one slice (solid, grow, open, close, fill holes, hull) to a region there;
/// leaves others alone.
void apply_shape_step(const StartStep& step, const SlicePose& pose, Image<float>& phi);

/// The same to all planes of an evenly spaced stack at once: grow, open and close move in three dimensions.
void apply_shape_step(const StartStep& step, const std::vector<SlicePose>& poses, double plane_distance_mm,
                      std::vector<Image<float>>& phi);

/// A region from a label map: half a pixel inside or outside, by the nearest voxel of every pixel centre.
Image<float> region_of_labels(const LabelStep& step, const SlicePose& pose, const Eigen::Vector2i& size_pixels);

}  // namespace isostack
