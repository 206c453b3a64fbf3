#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace isostack {

/// What a closed surface is spread out over, one to one: the unit sphere (genus 0), or a flat torus, the plane z = 1
/// with two periods (genus 1). A triangle mesh drawn on it has geodesic edges.
struct SurfaceDomain {
  int genus = 0;
  Eigen::Matrix<double, 3, 2> periods = Eigen::Matrix<double, 3, 2>::Zero();  ///< genus 1

  /// Positive where a → b → c runs counter-clockwise, seen from outside (the sphere) or from above; about twice the
  /// triangle's area.
  static double orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    return a.dot(b.cross(c));
  }
  /// From a the shortest way to b, as long as it is (on the sphere, along a great circle); to the nearest copy of b.
  Eigen::Vector3d way(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    if (genus > 0) return b - a + periods * copy_near(a, b).cast<double>();
    Eigen::Vector3d across = b - a.dot(b) * a;
    if (across.norm() > 1e-12) return std::atan2(across.norm(), a.dot(b)) * across.normalized();
    if (a.dot(b) > 0) return across;
    return std::numbers::pi * a.unitOrthogonal();  // opposite: any way
  }
  /// Which copy of b is nearest to a: periods to add to b (where periods are nearly at right angles).
  Eigen::Vector2i copy_near(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    if (genus == 0) return Eigen::Vector2i::Zero();
    const Eigen::Vector2d off = periods.topRows<2>().inverse() * (a - b).head<2>();
    return {static_cast<int>(std::lround(off.x())), static_cast<int>(std::lround(off.y()))};
  }
  /// Half the shortest way.
  Eigen::Vector3d halfway(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    return genus == 0 ? Eigen::Vector3d((a + b).normalized())
                      : Eigen::Vector3d((a + b + periods * copy_near(a, b).cast<double>()) / 2);
  }
  double distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const { return way(a, b).norm(); }
  /// The nearest point of the domain.
  Eigen::Vector3d onto(const Eigen::Vector3d& p) const {
    return genus == 0 ? p.normalized() : Eigen::Vector3d(p.x(), p.y(), 1);
  }
};

/// Which copy of a vertex a triangle's corner is: periods to add. All 0 on the sphere.
using CornerOffsets = std::array<Eigen::Vector2i, 3>;

/// Triangles drawn on a domain. On the torus each triangle is drawn once, anywhere in the plane.
struct DomainMesh {
  SurfaceDomain domain;
  std::vector<Eigen::Vector3d> positions;  ///< one for each vertex
  std::vector<Eigen::Vector3i> triangles;
  std::vector<CornerOffsets> offsets;  ///< one for each triangle

  /// Of the corner, drawn where the copy of corner `from` has no offset.
  Eigen::Vector3d corner(int triangle, int number, int from) const {
    const auto t = static_cast<std::size_t>(triangle);
    const auto& copies = offsets[t];
    const Eigen::Vector3d& p = positions[static_cast<std::size_t>(triangles[t][number])];
    if (domain.genus == 0 || number == from) return p;
    return p + domain.periods *
                   (copies[static_cast<std::size_t>(number)] - copies[static_cast<std::size_t>(from)]).cast<double>();
  }
};

}  // namespace isostack
