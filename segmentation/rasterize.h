#pragma once

#include <cstdint>

#include "recon/geometry/contour.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// Sets the voxels whose centre lies within the organ's contours (even-odd) to `label`, on those
/// k-planes of the grid that coincide with a slice (within a tenth of the plane distance). Throws
/// GeometryError when a slice with contours lies on none.
void rasterize(const ContourStack& organ, std::uint16_t label, LabelVolume& labels);

}  // namespace isostack
