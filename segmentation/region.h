#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/geometry/slice.h"
#include "segmentation/components.h"
#include "segmentation/field.h"

namespace isostack {

// A region is a field that is >= 0 inside (any scale): one image per slice, or one Field in D dimensions.

Mask inside_of(const Image<float>& phi);

/// Flips the sign where the mask says so; curves that stay keep their sub-pixel place.
void impose(const Mask& inside, Image<float>& phi);

/// Keeps the largest 3D part of planes in order along the normal.
void keep_largest(std::vector<Image<float>>& phi);

/// Planes of an evenly spaced stack as one field, axis 2 from plane to plane, and back.
Field<3> field_of(const std::vector<Image<float>>& planes, const Eigen::Vector3d& spacing_mm);
std::vector<Image<float>> planes_of(const Field<3>& field);

/// Regions that share no pixel: where several hold one, it goes to the deepest, and the curve between two follows the
/// places of equal depth. All in mm, on the same pixels.
void part_regions(std::vector<Image<float>*> distances_mm);

}  // namespace isostack
