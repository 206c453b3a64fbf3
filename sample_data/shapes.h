#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace isostack {

/// A figure in the plane with a closed form: signed distance to its edge in mm, or a bound of it where it is not near,
/// positive inside. All fit into the square from (4, 4) to (91, 91).
struct PlaneFigure {
  std::string name;
  std::function<double(const Eigen::Vector2d& point_mm)> distance_mm;
};

/// An x with arms of equal width, an o (a ring), a star with five points, two discs, and a bone-like letter.
std::vector<PlaneFigure> plane_figures();

/// A body with a closed form, some 90 mm large, centred on the world's origin: positive inside.
struct Body {
  std::string name;
  int genus = 0;
  std::function<double(const Eigen::Vector3d& point_mm)> depth_mm;
};

/// A sphere of radius 30 mm, a torus of radii 28 and 11 mm, a trefoil knot of radius 7 mm and a star with twelve
/// points.
std::vector<Body> bodies();

}  // namespace isostack
