#pragma once

#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/label_map.h"
#include "recon/geometry/progress.h"
#include "segmentation/segment.h"

namespace isostack {

/// Labels cut back onto planes, such as those of an image series: each pixel of a plane takes the value of the voxel it
/// lies in (none outside the grid), and each segment is traced there as by trace_label. One organ per segment, with its
/// name and colour and one slice per plane; no contours where it is absent. Throws GeometryError naming a plane whose
/// size in pixels is unknown, InputError naming a segment that no plane shows.
std::vector<ContourStack> label_sections(const LabelMap& labels, const std::vector<Segment>& segments,
                                         const std::vector<ContourSlice>& planes, const LabelOptions& options = {},
                                         const Progress& progress = {});

}  // namespace isostack
