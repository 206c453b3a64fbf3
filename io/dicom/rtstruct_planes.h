#pragma once

#include <string>
#include <vector>

#include "io/dicom/rtstruct_file.h"
#include "recon/geometry/contour.h"

namespace isostack {

/// The planes of a structure set and where its closed contours lie among them.
struct RtPlanes {
  /// Without contours; name, pose and size of the image where there is one, unit spacing otherwise. Ordered by
  /// direction, then along the normal.
  std::vector<ContourSlice> planes;
  std::vector<int> direction_of;           ///< of each plane; equal for parallel planes
  std::vector<double> height_mm;           ///< of each plane along its direction's normal
  std::vector<std::vector<int>> plane_of;  ///< [roi][contour]; -1 for contours that are left out
  std::vector<std::string> warnings;       ///< about contours left out
};

/// Groups closed planar contours by plane. A contour's plane is the mean one by Newell's method, or one parallel to
/// the images or to a larger contour if that fits as well, for the direction of small contours is uncertain.
RtPlanes find_planes(const std::vector<RtRoi>& rois, const std::vector<ContourSlice>& images);

/// True of the types that enclose an area.
bool is_closed(const RtContour& contour);

}  // namespace isostack
