#pragma once

#include <vector>

#include "io/write_options.h"
#include "recon/geometry/contour.h"

namespace isostack {

/// The planes of what options.like names, a DICOM image series (options.like_series chooses one of several) or a
/// volume: one slice without contours each, with its name, pose and size, as read_slices would order them. No pixels
/// are read. Throws InputError or GeometryError naming the file.
std::vector<ContourSlice> series_planes(const WriteOptions& options);

}  // namespace isostack
