#pragma once

#include <vector>

#include "recon/constraints/contour_samples.h"
#include "recon/geometry/contour.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// A place on an input plane where the surface's section strays from the contours.
struct StrayPoint {
  std::size_t slice = 0;
  Eigen::Vector2d point_in_slice_mm;
  double distance_mm = 0;  ///< to the slice's contours, positive inside; minus a pixel where the slice has none
};

/// Where cutting the surface with the input planes does not give the contours back.
struct SectionDeviations {
  std::vector<ContourSample> missed;  ///< on contours, farther than the tolerance from the section
  std::vector<double> missed_by_mm;   ///< infinite where the plane does not meet the surface
  std::vector<StrayPoint> stray;      ///< on the section, farther than the tolerance from the contours
  double mean_pixels = 0;             ///< of all contour points' distances to the section, where the plane has one

  bool empty() const { return missed.empty() && stray.empty(); }
};

/// Compares sections and contours of every plane at steps of a quarter of a pixel. The tolerance is in pixels of
/// each slice.
SectionDeviations section_deviations(const TriangleMesh& surface, const ContourStack& contours,
                                     double tolerance_pixels);

/// The farthest first, spread out by half their distance and `least_spacing_mm` at least; `most` at most.
std::vector<StrayPoint> farthest_strays(std::vector<StrayPoint> strays, double least_spacing_mm, std::size_t most);

}  // namespace isostack
