#include "recon/metrics/point_triangle.h"

#include <algorithm>

namespace isostack {

namespace {

Eigen::Vector3d closest_point_on_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p) {
  const Eigen::Vector3d ab = b - a;
  const double length2 = ab.squaredNorm();
  return a + (length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0) * ab;
}

}  // namespace

Eigen::Vector3d closest_point_on_triangle(const Triangle& triangle, const Eigen::Vector3d& p) {
  const auto& [a, b, c] = triangle;
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
  // Barycentric coordinates of the projection onto the plane.
  const double d00 = ab.dot(ab), d01 = ab.dot(ac), d11 = ac.dot(ac), d20 = ap.dot(ab), d21 = ap.dot(ac);
  const double determinant = d00 * d11 - d01 * d01;
  // A sliver's coordinates would be rounding noise; its edges are as near as its face.
  if (determinant > 1e-12 * d00 * d11) {
    const double v = (d11 * d20 - d01 * d21) / determinant, w = (d00 * d21 - d01 * d20) / determinant;
    if (v >= 0 && w >= 0 && v + w <= 1) return a + v * ab + w * ac;
  }
  const Eigen::Vector3d candidates[3] = {closest_point_on_segment(a, b, p), closest_point_on_segment(b, c, p),
                                         closest_point_on_segment(c, a, p)};
  return *std::min_element(std::begin(candidates), std::end(candidates),
                           [&](const auto& x, const auto& y) { return (x - p).squaredNorm() < (y - p).squaredNorm(); });
}

}  // namespace isostack
