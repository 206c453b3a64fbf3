#include "recon/subdivision/base_mesh.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace isostack {

namespace {

std::vector<Eigen::Vector3d> icosahedron() {
  const double golden = std::numbers::phi;
  std::vector<Eigen::Vector3d> corners;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-golden, golden})
      for (int axis = 0; axis < 3; ++axis) {
        Eigen::Vector3d& p = corners.emplace_back(Eigen::Vector3d::Zero());
        p[axis] = a;
        p[(axis + 1) % 3] = b;
        p.normalize();
      }
  return corners;
}

std::vector<Eigen::Vector3d> even_points(int count) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, turn = 2 * std::numbers::pi * i / std::numbers::phi;
    points.emplace_back(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
  }
  return points;
}

double nearest_cosine(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& p) {
  double best = -1;
  for (const Eigen::Vector3d& q : points) best = std::max(best, q.dot(p));
  return best;
}

/// Points repel each other; the first `fixed` stay.
void spread(std::vector<Eigen::Vector3d>& points, std::size_t fixed) {
  for (int pass = 0; pass < 200; ++pass)
    for (std::size_t i = fixed; i < points.size(); ++i) {
      Eigen::Vector3d push = Eigen::Vector3d::Zero();
      for (std::size_t j = 0; j < points.size(); ++j)
        if (j != i) push += (points[i] - points[j]) / std::pow((points[i] - points[j]).norm(), 3);
      push -= push.dot(points[i]) * points[i];
      points[i] = (points[i] + 0.02 * push / std::max(1.0, push.norm())).normalized();
    }
}

void fill_gaps(std::vector<Eigen::Vector3d>& points, const BaseMeshOptions& options) {
  const std::size_t asked = points.size();
  const std::vector<Eigen::Vector3d> places = even_points(2000);
  const auto lonelier = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return nearest_cosine(points, a) < nearest_cosine(points, b);
  };
  while (true) {
    const Eigen::Vector3d loneliest = *std::min_element(places.begin(), places.end(), lonelier);
    const double gap = std::acos(std::clamp(nearest_cosine(points, loneliest), -1.0, 1.0)) * 180 / std::numbers::pi;
    if (static_cast<int>(points.size()) >= options.vertices && gap <= options.widest_gap_degrees) return;
    points.push_back(loneliest);
    spread(points, asked);
  }
}

}  // namespace

DomainMesh sphere_base(const std::vector<Eigen::Vector3d>& points, const BaseMeshOptions& options) {
  DomainMesh base;
  base.positions = points;
  if (points.empty() && options.vertices <= 12)
    base.positions = icosahedron();
  else
    fill_gaps(base.positions, options);
  // Points on one circle are no triangle's more than another's: a hair's breadth decides.
  std::mt19937 random(9);
  std::uniform_real_distribution<double> hair(-1e-7, 1e-7);
  std::vector<Eigen::Vector3d> moved = base.positions;
  for (Eigen::Vector3d& p : moved) p += Eigen::Vector3d(hair(random), hair(random), hair(random));
  const int n = static_cast<int>(moved.size());
  const auto at = [&](int i) -> const Eigen::Vector3d& { return moved[static_cast<std::size_t>(i)]; };
  // Delaunay triangles are the faces of the convex hull.
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b)
      for (int c = b + 1; c < n; ++c) {
        const Eigen::Vector3d normal = (at(b) - at(a)).cross(at(c) - at(a));
        const double side = normal.dot(at(a)) < 0 ? -1 : 1;
        bool is_face = true;
        for (int d = 0; d < n && is_face; ++d)
          is_face = d == a || d == b || d == c || side * normal.dot(at(d) - at(a)) < 0;
        if (is_face) base.triangles.push_back(side > 0 ? Eigen::Vector3i(a, b, c) : Eigen::Vector3i(a, c, b));
      }
  base.offsets.resize(base.triangles.size());
  for (CornerOffsets& offsets : base.offsets) offsets.fill(Eigen::Vector2i::Zero());
  return base;
}

DomainMesh torus_base(const Eigen::Vector2i& around) {
  DomainMesh base;
  base.domain.genus = 1;
  Eigen::Matrix<double, 3, 2> steps;
  steps << 1, 0.5, 0, std::sqrt(0.75), 0, 0;
  base.domain.periods = steps * around.cast<double>().asDiagonal();
  for (int j = 0; j < around[1]; ++j)
    for (int i = 0; i < around[0]; ++i)
      base.positions.emplace_back(steps * Eigen::Vector2d(i, j) + Eigen::Vector3d::UnitZ());
  const auto add = [&](std::array<Eigen::Vector2i, 3> corners) {
    Eigen::Vector3i& triangle = base.triangles.emplace_back();
    CornerOffsets& offsets = base.offsets.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      offsets[c] = corners[c].array() / around.array();
      const Eigen::Vector2i own = corners[c].array() - offsets[c].array() * around.array();
      triangle[static_cast<Eigen::Index>(c)] = own[1] * around[0] + own[0];
    }
  };
  for (int j = 0; j < around[1]; ++j)
    for (int i = 0; i < around[0]; ++i) {
      add({Eigen::Vector2i(i, j), Eigen::Vector2i(i + 1, j), Eigen::Vector2i(i, j + 1)});
      add({Eigen::Vector2i(i + 1, j), Eigen::Vector2i(i + 1, j + 1), Eigen::Vector2i(i, j + 1)});
    }
  return base;
}

std::vector<Eigen::Vector3d> dual_points(const DomainMesh& base) {
  std::vector<Eigen::Vector3d> points;
  for (int t = 0; t < static_cast<int>(base.triangles.size()); ++t) {
    const Eigen::Vector3d a = base.corner(t, 0, 0), b = base.corner(t, 1, 0), c = base.corner(t, 2, 0);
    points.push_back(base.domain.genus == 0 ? Eigen::Vector3d((b - a).cross(c - a).normalized())
                                            : Eigen::Vector3d((a + b + c) / 3));  // equilateral
  }
  return points;
}

}  // namespace isostack
