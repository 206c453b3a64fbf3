// Bodies of other shapes and topologies than a sphere's, to morph into each other.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "tests/support/analytic_meshes.h"

namespace isostack::testing_support {

/// A flat cushion with five arms in the plane z = 0: genus 0.
inline TriangleMesh star_mesh(double radius_mm, int meridians, int parallels) {
  TriangleMesh mesh = sphere_mesh(Eigen::Vector3d::Zero(), 1, meridians, parallels);
  for (Eigen::Vector3d& v : mesh.vertices_mm) {
    const double belt = v.x() * v.x() + v.y() * v.y();
    const double reach = 1 + 0.4 * std::cos(5 * std::atan2(v.y(), v.x())) * belt;
    v = radius_mm / 1.4 * Eigen::Vector3d(reach * v.x(), reach * v.y(), 0.5 * v.z());
  }
  mesh.name = "star";
  return mesh;
}

/// A tube round a trefoil knot, whose strands are nowhere nearer than 0.49 radii: genus 1.
inline TriangleMesh knot_mesh(double radius_mm, double tube_mm, int along, int around_tube) {
  const auto centre = [=](double u) -> Eigen::Vector3d {
    return radius_mm / 3 *
           Eigen::Vector3d(std::sin(u) + 2 * std::sin(2 * u), std::cos(u) - 2 * std::cos(2 * u),
                           -1.5 * std::sin(3 * u));
  };
  TriangleMesh mesh = wrapped_mesh(along, around_tube, [=](double u, double v) -> Eigen::Vector3d {
    constexpr double step = 1e-3;
    const Eigen::Vector3d before = centre(u - step), here = centre(u), after = centre(u + step);
    const Eigen::Vector3d tangent = (after - before).normalized();
    const Eigen::Vector3d bend = after - 2 * here + before;
    const Eigen::Vector3d normal = (bend - tangent * tangent.dot(bend)).normalized();  // a trefoil bends everywhere
    return here + tube_mm * (std::cos(v) * normal + std::sin(v) * normal.cross(tangent));
  });
  mesh.name = "knot";
  return mesh;
}

/// The mesh with every triangle turned over.
inline TriangleMesh inside_out(TriangleMesh mesh) {
  for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Both meshes as one.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<int>(a.vertices_mm.size());
  a.vertices_mm.insert(a.vertices_mm.end(), b.vertices_mm.begin(), b.vertices_mm.end());
  for (const Eigen::Vector3i& t : b.triangles) a.triangles.emplace_back(t.array() + first);
  return a;
}

}  // namespace isostack::testing_support
