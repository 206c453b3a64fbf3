#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// Distance in the plane to the nearest segment of some contours, prepared for many points.
class ContourDistance {
 public:
  /// Throws InputError when there is no contour.
  explicit ContourDistance(const std::vector<Contour>& contours);
  ~ContourDistance();

  /// Unsigned, mm.
  double to(const Eigen::Vector2d& point_in_slice_mm) const;

 private:
  struct Segments;
  std::unique_ptr<const Segments> segments_;
};

/// Points along the closed curves, evenly by length, at most `step_mm` apart.
std::vector<Eigen::Vector2d> points_along(const std::vector<Contour>& contours, double step_mm);

}  // namespace isostack
