#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recon/geometry/label_map.h"

namespace isostack {

/// One frame of a segmentation to be written.
struct SegmentPlane {
  std::uint16_t segment = 1;  ///< its number
  int k = 0;                  ///< plane of the grid
};

/// A label map as the frames of a binary segmentation.
struct SegmentPlanes {
  std::vector<Segment> segments;  ///< value: number, 1, 2, 3, ... as DICOM demands; layer: as in the map
  std::vector<SegmentPlane> frames;
  std::string bits;  ///< of all frames, packed without gaps, first pixel in the lowest bit; an even number of bytes
};

/// Numbers are the values where these are 1, 2, 3, ... Planes without a voxel of a segment are left out, but the first
/// and the last plane of the grid always have a frame. Throws InputError naming `where` when there is nothing to
/// write or it does not fit into a DICOM file.
SegmentPlanes planes_of_segments(const LabelMap& map, const std::string& where);

}  // namespace isostack
