#pragma once

#include <string>

#include "io/volumes/text_header.h"
#include "recon/geometry/label_map.h"

namespace isostack {

/// Names the map's segments after the fields Segment0_Name, Segment0_Color, Segment0_Layer, Segment0_LabelValue and
/// so on of 3D Slicer. Files from before there were layers have one segment of value 1 per layer. Segments of layers
/// or values that cannot be are left out with a warning.
void add_nrrd_segments(const TextHeader& fields, LabelMap& map);

/// The same fields as lines of a header, also for values that no segment names, with extents.
std::string nrrd_segment_lines(const LabelMap& map);

}  // namespace isostack
