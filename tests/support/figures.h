#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "recon/metrics/contour_distance.h"
#include "recon/morphing/shape.h"
#include "recon/surface/zero_contours.h"

namespace isostack::testing_support {

/// Where a function of the plane is positive within a square of this side from the origin, in pixels of 1 mm.
inline KeyShape figure(const std::string& name, double side_mm,
                       const std::function<double(const Eigen::Vector2d&)>& inside_mm) {
  const PlaneLattice lattice = lattice_over({Eigen::Vector2d(0, 0), Eigen::Vector2d(side_mm, side_mm)}, 1);
  const PlaneFunction function = [&](const Eigen::Matrix2Xd& points) {
    Eigen::VectorXd values(points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) values[i] = inside_mm(points.col(i));
    return values;
  };
  ContourSlice slice;
  slice.name = name;
  slice.contours = zero_contours(function, lattice, function(nodes_of(lattice)), 0.002);
  return {.name = name, .shape = slice};
}

inline KeyShape disc(const std::string& name, const Eigen::Vector2d& centre_mm, double radius_mm) {
  return figure(name, 100, [=](const Eigen::Vector2d& p) { return radius_mm - (p - centre_mm).norm(); });
}

/// A ring 16 mm wide about (50, 50).
inline KeyShape o_figure() {
  return figure("O", 100,
                [](const Eigen::Vector2d& p) { return 8 - std::abs((p - Eigen::Vector2d(50, 50)).norm() - 30); });
}

/// Two round-ended bars 16 mm wide, crossing at (50, 50), their inner corners rounded.
inline KeyShape x_figure() {
  const auto to_bar = [](const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - share * (b - a)).norm() - 8;
  };
  return figure("X", 100, [=](const Eigen::Vector2d& p) {
    constexpr double fillet = 10;
    const double one = to_bar(p, {20, 20}, {80, 80}), other = to_bar(p, {20, 80}, {80, 20});
    const double near = std::max(fillet - std::abs(one - other), 0.0) / fillet;
    return near * near * fillet / 4 - std::min(one, other);
  });
}

inline std::vector<Contour> contours_of(const Shape& shape) { return std::get<ContourSlice>(shape).contours; }

/// Hausdorff distance between the curves, mm.
inline double largest_distance(const std::vector<Contour>& a, const std::vector<Contour>& b) {
  const ContourDistance to_a(a), to_b(b);
  double largest = 0;
  for (const Eigen::Vector2d& p : points_along(a, 0.1)) largest = std::max(largest, to_b.to(p));
  for (const Eigen::Vector2d& p : points_along(b, 0.1)) largest = std::max(largest, to_a.to(p));
  return largest;
}

/// The figure turned about the plane's origin by an angle, then shifted.
inline KeyShape moved(KeyShape shape, double angle_rad, const Eigen::Vector2d& shift_mm) {
  const Eigen::Rotation2Dd turn(angle_rad);
  for (Contour& contour : std::get<ContourSlice>(shape.shape).contours)
    for (Eigen::Vector2d& point : contour.points_mm) point = turn * point + shift_mm;
  return shape;
}

}  // namespace isostack::testing_support
