#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/color.h"
#include "recon/geometry/slice_pose.h"

namespace isostack {

/// A closed planar curve in slice coordinates (mm); the last point joins the first and is not
/// repeated. The organ lies to the left when walking along: outer curves have positive
/// signed area in (x, y), holes negative.
struct Contour {
  std::vector<Eigen::Vector2d> points_mm;
  int depth = 0;  ///< nesting: 0 outer, 1 hole, 2 island within a hole, ...
};

/// What one slice says about one organ. Without contours the organ is absent here: everything
/// within the field of view is outside.
struct ContourSlice {
  std::string name;
  SlicePose pose;
  Eigen::Vector2i size_pixels = Eigen::Vector2i::Zero();  ///< columns, rows of the image; zero: unknown extent
  std::vector<Contour> contours;
};

/// All contours of one organ.
struct ContourStack {
  std::string name;
  std::vector<ContourSlice> slices;
  std::optional<Color> color = std::nullopt;
  std::string roi_type = {};  ///< DICOM RT ROI Interpreted Type such as "ORGAN"; empty: unknown
};

double signed_area_mm2(const Contour& contour);
double perimeter_mm(const Contour& contour);

/// Even-odd rule over all loops of the slice.
bool is_inside(const std::vector<Contour>& contours, const Eigen::Vector2d& point_in_slice_mm);

/// Distance to the nearest curve, mm, positive inside; minus infinity where there is no contour.
double signed_distance_mm(const std::vector<Contour>& contours, const Eigen::Vector2d& point_in_slice_mm);

/// True when `inner` lies within `outer`. Curves may touch in points or along edges, but do not cross; two that
/// coincide do not enclose each other.
bool encloses(const Contour& outer, const Contour& inner);

/// Sets every contour's depth by containment and orients it to match (outer positive).
void orient_by_nesting(std::vector<Contour>& contours);

std::size_t point_count(const ContourStack& stack);

}  // namespace isostack
