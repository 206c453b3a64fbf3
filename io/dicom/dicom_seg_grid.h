#pragma once

#include <string>
#include <vector>

#include "io/dicom/dicom_header.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// A grid on which frames of a segmentation lie.
struct FrameGrid {
  Grid grid;
  std::vector<int> plane_of_frame;  ///< k of each frame of the file; -1: it does not lie on this grid
  std::vector<std::string> warnings;
};

/// The frames do not lie on one even grid: a label map cannot hold them, each plane by itself can.
class UnevenFrames : public GeometryError {
 public:
  UnevenFrames(const std::string& where, const std::string& problem);
  const std::string& problem() const { return problem_; }

 private:
  std::string problem_;
};

/// Planes are one SpacingBetweenSlices apart where that fits the frames' positions, else the largest distance that
/// does; planes between them may have no frame. Throws InputError or GeometryError naming the file or frame when
/// one has no pose, or far more planes lie between the frames than frames are there; UnevenFrames when the frames
/// are not parallel, not of one pixel size, shifted against each other or unevenly spaced.
FrameGrid grid_of_frames(const DicomHeader& image);

/// One grid of a single plane for each place where frames lie, in the order of order_along_normals.
std::vector<FrameGrid> planes_of_frames(const DicomHeader& image);

}  // namespace isostack
