#pragma once

#include <Eigen/Core>

namespace isostack {

/// A surface's triangle, as the energy sees it: squared lengths of the sides opposite its corners and its area.
struct SurfaceTriangle {
  Eigen::Vector3d squared_sides = Eigen::Vector3d::Zero();
  double area = 0;
};

/// `least_squared` is added to each squared side, so that also a triangle without size asks for some place.
SurfaceTriangle surface_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                 double least_squared = 0);

/// How much the map domain → surface stretches, squared, times the surface's area (Sander et al. 2001, Section 3): it
/// grows without bound as the triangle (p, q, r) of the domain loses its area, so its minimum samples evenly and turns
/// nothing over. (p, q, r) is on the unit sphere or the plane z = 1, its area taken as |p q r| / 2: near enough where
/// it is small, and less than true where it is large, 0 at a great circle. Times 4.
double stretch(const SurfaceTriangle& on_surface, const Eigen::Vector3d& p, const Eigen::Vector3d& q,
               const Eigen::Vector3d& r);

/// Its derivative by p is added.
void add_stretch_gradient(const SurfaceTriangle& on_surface, const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                          const Eigen::Vector3d& r, Eigen::Vector3d& gradient);

}  // namespace isostack
