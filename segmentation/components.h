#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "recon/geometry/slice.h"

namespace isostack {

/// 1 inside, 0 outside, indexed (row, column).
using Mask = Image<std::uint8_t>;

/// Background that is not 4-connected to the image's border becomes organ.
Mask fill_holes(const Mask& mask);

/// Keeps the 3D component with the most pixels (the first one met among equals); masks are planes in order along
/// the normal. Connectivity is 6: 4-neighbours in a plane and the same pixel in the next plane.
/// Throws GeometryError when the masks differ in size.
std::vector<Mask> largest_component(std::vector<Mask> masks);

/// Indices of the slices in order along their normal. Throws GeometryError unless all are parallel with the
/// same axes, spacing and raster size, so that equal pixels lie above each other; gaps may vary.
std::vector<std::size_t> stacking_order(const SliceStack& stack);

}  // namespace isostack
