#pragma once

#include <string>
#include <vector>

#include "io/dicom_header.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// The grid on which a segmentation's frames lie.
struct FrameGrid {
  Grid grid;
  std::vector<int> plane_of_frame;  ///< k of each frame
  std::vector<std::string> warnings;
};

/// Planes are one SpacingBetweenSlices apart where that fits the frames' positions, else the largest distance that
/// does; planes between them may have no frame. Throws InputError or GeometryError naming the file or frame when
/// one has no pose, or the frames are not parallel, not of one pixel size, shifted against each other or unevenly
/// spaced, or when far more planes lie between the frames than frames are there.
FrameGrid grid_of_frames(const DicomHeader& image);

}  // namespace isostack
