#include "recon/morphing/densified.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostack {

std::vector<Contour> densified(std::vector<Contour> contours, double step_mm) {
  for (Contour& contour : contours) {
    std::vector<Eigen::Vector2d> points;
    for (std::size_t i = 0; i < contour.points_mm.size(); ++i) {
      const Eigen::Vector2d &a = contour.points_mm[i], &b = contour.points_mm[(i + 1) % contour.points_mm.size()];
      const double parts = std::max(1.0, std::ceil((b - a).norm() / step_mm - 1e-9));
      for (double part = 0; part < parts; ++part) points.push_back(a + part / parts * (b - a));
    }
    contour.points_mm = std::move(points);
  }
  return contours;
}

}  // namespace isostack
