#include "recon/subdivision/stretch.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace isostack {

namespace {

/// Dots of the two sides at each corner: times the squared sides of the surface they sum to the Dirichlet energy.
Eigen::Vector3d corner_dots(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r) {
  return {(q - p).dot(r - p), (p - q).dot(r - q), (p - r).dot(q - r)};
}

}  // namespace

SurfaceTriangle surface_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                 double least_squared) {
  SurfaceTriangle made{{(b - c).squaredNorm(), (a - c).squaredNorm(), (a - b).squaredNorm()},
                       (b - a).cross(c - a).norm() / 2};
  made.squared_sides.array() += least_squared;
  // A triangle without area still asks for some place.
  made.area = std::max(made.area, 1e-6 * made.squared_sides.sum());
  return made;
}

double stretch(const SurfaceTriangle& on_surface, const Eigen::Vector3d& p, const Eigen::Vector3d& q,
               const Eigen::Vector3d& r) {
  const double area = p.dot(q.cross(r));
  return on_surface.area * on_surface.squared_sides.dot(corner_dots(p, q, r)) / (area * area);
}

void add_stretch_gradient(const SurfaceTriangle& on_surface, const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                          const Eigen::Vector3d& r, Eigen::Vector3d& gradient) {
  const Eigen::Vector3d of_area = q.cross(r), &sides = on_surface.squared_sides;
  const double area = p.dot(of_area);
  const Eigen::Vector3d of_dots = sides[0] * (2 * p - q - r) + sides[1] * (r - q) + sides[2] * (q - r);
  gradient += on_surface.area / (area * area) * (of_dots - 2 * sides.dot(corner_dots(p, q, r)) / area * of_area);
}

}  // namespace isostack
