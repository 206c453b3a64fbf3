#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "recon/geometry/triangle_mesh.h"

namespace isostack::testing_support {

/// A box from `low` to `high`, twelve triangles facing outwards.
inline TriangleMesh box_mesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  TriangleMesh mesh{.name = "box", .vertices_mm = {}, .triangles = {}, .normals = {}};
  for (int c = 0; c < 8; ++c)
    mesh.vertices_mm.emplace_back((c & 1 ? high : low).x(), (c & 2 ? high : low).y(), (c & 4 ? high : low).z());
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

/// A closed sheet over an nu × nv lattice that joins round in both directions.
template <class Position>
TriangleMesh wrapped_mesh(int nu, int nv, Position position) {
  TriangleMesh mesh{.name = "wrapped", .vertices_mm = {}, .triangles = {}, .normals = {}};
  for (int v = 0; v < nv; ++v)
    for (int u = 0; u < nu; ++u)
      mesh.vertices_mm.push_back(position(2 * std::numbers::pi * u / nu, 2 * std::numbers::pi * v / nv));
  for (int v = 0; v < nv; ++v)
    for (int u = 0; u < nu; ++u) {
      const int a = v * nu + u, b = v * nu + (u + 1) % nu;
      const int c = (v + 1) % nv * nu + (u + 1) % nu, d = (v + 1) % nv * nu + u;
      mesh.triangles.emplace_back(a, b, c);
      mesh.triangles.emplace_back(a, c, d);
    }
  return mesh;
}

inline TriangleMesh torus_mesh(double ring_mm, double tube_mm, int around_ring, int around_tube) {
  return wrapped_mesh(around_ring, around_tube, [=](double u, double v) {
    const double from_axis = ring_mm + tube_mm * std::cos(v);
    return Eigen::Vector3d(from_axis * std::cos(u), from_axis * std::sin(u), tube_mm * std::sin(v));
  });
}

/// A sphere by parallels and meridians, poles included; all vertices lie on the sphere.
inline TriangleMesh sphere_mesh(const Eigen::Vector3d& centre_mm, double radius_mm, int meridians, int parallels) {
  TriangleMesh mesh{.name = "sphere", .vertices_mm = {}, .triangles = {}, .normals = {}};
  for (int p = 1; p < parallels; ++p)
    for (int m = 0; m < meridians; ++m) {
      const double down = std::numbers::pi * p / parallels, round = 2 * std::numbers::pi * m / meridians;
      mesh.vertices_mm.push_back(centre_mm + radius_mm * Eigen::Vector3d(std::sin(down) * std::cos(round),
                                                                         std::sin(down) * std::sin(round),
                                                                         std::cos(down)));
    }
  const int top = static_cast<int>(mesh.vertices_mm.size()), bottom = top + 1;
  mesh.vertices_mm.push_back(centre_mm + radius_mm * Eigen::Vector3d::UnitZ());
  mesh.vertices_mm.push_back(centre_mm - radius_mm * Eigen::Vector3d::UnitZ());
  for (int m = 0; m < meridians; ++m) {
    const int next = (m + 1) % meridians, last = (parallels - 2) * meridians;
    mesh.triangles.emplace_back(top, m, next);
    mesh.triangles.emplace_back(bottom, last + next, last + m);
    for (int p = 0; p + 2 < parallels; ++p) {
      const int a = p * meridians, b = a + meridians;
      mesh.triangles.emplace_back(a + m, b + m, b + next);
      mesh.triangles.emplace_back(a + m, b + next, a + next);
    }
  }
  return mesh;
}

/// The mesh moved by `motion` (a rotation and translation).
inline TriangleMesh moved(TriangleMesh mesh, const Eigen::Isometry3d& motion) {
  for (Eigen::Vector3d& v : mesh.vertices_mm) v = motion * v;
  return mesh;
}

}  // namespace isostack::testing_support
