#include "sample_data/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace isostack {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double pi = std::numbers::pi;
const Vector2d middle(47.5, 47.5);

double box_distance(const Vector2d& p, const Vector2d& half_size) {
  const Vector2d outside = p.cwiseAbs() - half_size;
  return -(outside.cwiseMax(0).norm() + std::min(outside.maxCoeff(), 0.0));
}

double disc_distance(const Vector2d& p, const Vector2d& centre, double radius) { return radius - (p - centre).norm(); }

double x_distance(const Vector2d& p) {
  const Vector2d arm(41, 8);
  double nearest = -std::numeric_limits<double>::infinity();
  for (const double angle : {pi / 4, -pi / 4})
    nearest = std::max(nearest, box_distance(Eigen::Rotation2Dd(angle) * (p - middle), arm));
  return nearest;
}

double o_distance(const Vector2d& p) { return 9 - std::abs((p - middle).norm() - 29); }

/// Distance to a closed polygon, positive inside (even-odd).
double polygon_distance(const Vector2d& p, const std::vector<Vector2d>& corners) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d& a = corners[i];
    const Vector2d& b = corners[(i + 1) % corners.size()];
    const double along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - along * (b - a)).norm());
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside ? nearest : -nearest;
}

double star_distance(const Vector2d& p) {
  std::vector<Vector2d> corners;
  for (int i = 0; i < 10; ++i) {
    const double angle = pi * (i / 5.0 - 0.5), radius = i % 2 == 0 ? 41 : 18;
    corners.push_back(middle + radius * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return polygon_distance(p, corners);
}

double discs_distance(const Vector2d& p) {
  return std::max(disc_distance(p, {26, 47.5}, 17), disc_distance(p, {69, 47.5}, 17));
}

/// A shaft with two knobs at either end.
double bone_distance(const Vector2d& p) {
  double nearest = box_distance(p - middle, {7, 30});
  for (const double x : {37.5, 57.5})
    for (const double y : {18.0, 77.0}) nearest = std::max(nearest, disc_distance(p, {x, y}, 12));
  return nearest;
}

double torus_depth(const Vector3d& p) { return 11 - Vector2d(std::hypot(p.x(), p.y()) - 28, p.z()).norm(); }

Vector3d trefoil(double angle) {
  return 15.5 *
         Vector3d(std::sin(angle) + 2 * std::sin(2 * angle), std::cos(angle) - 2 * std::cos(2 * angle),
                  -1.2 * std::sin(3 * angle)) *
         0.8;
}

/// Distance to the curve by the nearest of many points, then along the chord there.
double knot_depth(const Vector3d& p) {
  constexpr int pieces = 240;
  static const std::vector<Vector3d> curve = [] {
    std::vector<Vector3d> points;
    for (int i = 0; i < pieces; ++i) points.push_back(trefoil(2 * pi * i / pieces));
    return points;
  }();
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pieces; ++i) {
    const Vector3d& a = curve[i];
    const Vector3d chord = curve[(i + 1) % pieces] - a;
    const double along = std::clamp((p - a).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - along * chord).squaredNorm());
  }
  return 7 - std::sqrt(nearest);
}

/// Radius by direction: a ball with smooth points towards the corners of an icosahedron.
double star_depth(const Vector3d& p) {
  static const std::vector<Vector3d> points = [] {
    std::vector<Vector3d> corners;
    const double golden = std::numbers::phi;
    for (const double a : {1.0, -1.0})
      for (const double b : {golden, -golden})
        for (int axis = 0; axis < 3; ++axis) {
          Vector3d corner = Vector3d::Zero();
          corner[axis] = a;
          corner[(axis + 1) % 3] = b;
          corners.push_back(corner.normalized());
        }
    return corners;
  }();
  const double length = p.norm();
  if (length < 1e-9) return 20;
  double radius = 20;
  for (const Vector3d& point : points) radius += 24 * std::exp(18 * (p.dot(point) / length - 1));
  return radius - length;
}

}  // namespace

std::vector<PlaneFigure> plane_figures() {
  return {{"x", x_distance},
          {"o", o_distance},
          {"star", star_distance},
          {"discs", discs_distance},
          {"bone", bone_distance}};
}

std::vector<Body> bodies() {
  return {{"sphere", 0, [](const Vector3d& p) { return 30 - p.norm(); }},
          {"torus", 1, torus_depth},
          {"knot", 1, knot_depth},
          {"star", 0, star_depth}};
}

}  // namespace isostack
