#include "recon/metrics/contour_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostack {

namespace {

/// A closed curve by the length along it.
class ArcLength {
 public:
  explicit ArcLength(const std::vector<Eigen::Vector2d>& points) : points_(points), lengths_{0} {
    for (std::size_t i = 0; i < points.size(); ++i)
      lengths_.push_back(lengths_.back() + (points[(i + 1) % points.size()] - points[i]).norm());
  }
  double total() const { return lengths_.back(); }
  double at_point(std::size_t i) const { return lengths_[i]; }
  Eigen::Vector2d place(double length) const {
    length -= total() * std::floor(length / total());
    const auto next = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
    const auto i = static_cast<std::size_t>(next - lengths_.begin()) - 1;
    const double edge = lengths_[i + 1] - lengths_[i];
    const double share = edge > 0 ? std::clamp((length - lengths_[i]) / edge, 0.0, 1.0) : 0;
    return points_[i] + share * (points_[(i + 1) % points_.size()] - points_[i]);
  }

 private:
  const std::vector<Eigen::Vector2d>& points_;
  std::vector<double> lengths_;  ///< of the curve up to each point, and of all of it
};

/// Of the circle through three points, positive when they turn left.
double curvature_through(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d ab = b - a, bc = c - b;
  const double product = ab.norm() * bc.norm() * (c - a).norm();
  return product > 0 ? 2 * (ab.x() * bc.y() - ab.y() * bc.x()) / product : 0;
}

}  // namespace

ContourMeasures measure(const std::vector<Contour>& contours, double scale_mm) {
  ContourMeasures result;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Contour& contour : contours) {
    const double area_mm2 = signed_area_mm2(contour);
    result.area_mm2 += area_mm2;
    result.perimeter_mm += perimeter_mm(contour);
    ++(area_mm2 > 0 ? result.components : result.holes);
    const ArcLength curve(contour.points_mm);
    const double step = std::min(scale_mm, curve.total() / 4);
    if (!(step > 0)) continue;
    for (std::size_t i = 0; i < contour.points_mm.size(); ++i) {
      const double here = curve.at_point(i);
      const double curvature =
          curvature_through(curve.place(here - step), contour.points_mm[i], curve.place(here + step));
      lowest = std::min(lowest, curvature);
      highest = std::max(highest, curvature);
    }
  }
  if (lowest <= highest) result.lowest_curvature_per_mm = lowest, result.highest_curvature_per_mm = highest;
  return result;
}

}  // namespace isostack
