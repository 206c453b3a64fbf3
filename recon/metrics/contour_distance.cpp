#include "recon/metrics/contour_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unsupported/Eigen/BVH>

#include "recon/geometry/errors.h"

namespace isostack {

struct ContourDistance::Segments {
  std::vector<Eigen::Vector2d> from, to;
  Eigen::KdBVH<double, 2, int> tree;

  double squared_distance(int segment, const Eigen::Vector2d& p) const {
    const Eigen::Vector2d& a = from[static_cast<std::size_t>(segment)];
    const Eigen::Vector2d along = to[static_cast<std::size_t>(segment)] - a;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (a + share * along - p).squaredNorm();
  }
};

ContourDistance::ContourDistance(const std::vector<Contour>& contours) {
  auto segments = std::make_unique<Segments>();
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const Contour& contour : contours)
    for (std::size_t i = 0; i < contour.points_mm.size(); ++i) {
      segments->from.push_back(contour.points_mm[i]);
      segments->to.push_back(contour.points_mm[(i + 1) % contour.points_mm.size()]);
      boxes.emplace_back(segments->from.back());
      boxes.back().extend(segments->to.back());
    }
  if (boxes.empty()) throw InputError("contour distance", "there is no contour", "give at least one");
  std::vector<int> numbers(boxes.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  segments->tree.init(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
  segments_ = std::move(segments);
}

ContourDistance::~ContourDistance() = default;

double ContourDistance::to(const Eigen::Vector2d& point_in_slice_mm) const {
  struct Nearest {
    using Scalar = double;
    const Segments& segments;
    Eigen::Vector2d point;
    // NOLINTBEGIN(readability-identifier-naming): Eigen calls them so.
    double minimumOnVolume(const Eigen::AlignedBox2d& box) const { return box.squaredExteriorDistance(point); }
    double minimumOnObject(int segment) const { return segments.squared_distance(segment, point); }
    // NOLINTEND(readability-identifier-naming)
  } query{*segments_, point_in_slice_mm};
  return std::sqrt(Eigen::BVMinimize(segments_->tree, query));
}

std::vector<Eigen::Vector2d> points_along(const std::vector<Contour>& contours, double step_mm) {
  std::vector<Eigen::Vector2d> points;
  for (const Contour& contour : contours) {
    const double length = perimeter_mm(contour);
    if (!(length > 0)) continue;
    const auto count = std::max(3.0, std::ceil(length / step_mm));
    double walked = 0, next = 0.5 * length / count;  // of the curve, from its first point
    for (std::size_t i = 0; i < contour.points_mm.size(); ++i) {
      const Eigen::Vector2d &a = contour.points_mm[i], &b = contour.points_mm[(i + 1) % contour.points_mm.size()];
      const double edge = (b - a).norm();
      for (; next < walked + edge; next += length / count) points.push_back(a + (next - walked) / edge * (b - a));
      walked += edge;
    }
  }
  return points;
}

}  // namespace isostack
