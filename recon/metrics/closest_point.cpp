#include "recon/metrics/closest_point.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numeric>
#include <unsupported/Eigen/BVH>
#include <vector>

#include "recon/geometry/errors.h"
#include "recon/metrics/point_triangle.h"

namespace isostack {

namespace {

using Box = Eigen::AlignedBox3d;

// What Eigen's tree asks for. NOLINTBEGIN(readability-identifier-naming): Eigen calls them so.

/// The smallest squared distance to a triangle that faces `direction` (any, when that is zero).
struct Nearest {
  using Scalar = double;
  const std::vector<Triangle>& triangles;
  const Eigen::Vector3d& point;
  const Eigen::Vector3d& direction;
  double best = std::numeric_limits<double>::infinity();
  Eigen::Vector3d closest = Eigen::Vector3d::Zero();
  int closest_triangle = 0;

  double minimumOnVolume(const Box& box) const { return box.squaredExteriorDistance(point); }
  double minimumOnObject(int triangle) {
    const Triangle& t = triangles[static_cast<std::size_t>(triangle)];
    if (!direction.isZero(0) && (t[1] - t[0]).cross(t[2] - t[0]).dot(direction) <= 0)
      return std::numeric_limits<double>::infinity();
    const Eigen::Vector3d candidate = closest_point_on_triangle(t, point);
    const double squared = (candidate - point).squaredNorm();
    if (squared < best) best = squared, closest = candidate, closest_triangle = triangle;
    return squared;
  }
};

/// Stops at the first triangle within the distance.
struct AnyWithin {
  const std::vector<Triangle>& triangles;
  const Eigen::Vector3d& point;
  double squared_distance;
  bool found = false;

  bool intersectVolume(const Box& box) const { return box.squaredExteriorDistance(point) <= squared_distance; }
  bool intersectObject(int triangle) {
    const Triangle& t = triangles[static_cast<std::size_t>(triangle)];
    found = (closest_point_on_triangle(t, point) - point).squaredNorm() <= squared_distance;
    return found;
  }
};

// NOLINTEND(readability-identifier-naming)

}  // namespace

struct ClosestPoint::Tree {
  std::vector<Triangle> triangles;
  Eigen::KdBVH<double, 3, int> boxes;
};

ClosestPoint::ClosestPoint(const TriangleMesh& mesh) {
  if (mesh.triangles.empty())
    throw InputError(mesh.name.empty() ? "mesh" : mesh.name, "the mesh has no triangles", "give a surface");
  auto tree = std::make_shared<Tree>();
  std::vector<Box> boxes(mesh.triangles.size());
  for (std::size_t n = 0; n < boxes.size(); ++n) {
    const Eigen::Vector3i& t = mesh.triangles[n];
    const auto corner = [&](int i) { return mesh.vertices_mm[static_cast<std::size_t>(t[i])]; };
    tree->triangles.push_back({corner(0), corner(1), corner(2)});
    for (const Eigen::Vector3d& p : tree->triangles.back()) boxes[n].extend(p);
  }
  std::vector<int> numbers(boxes.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  tree->boxes.init(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
  tree_ = tree;
}

ClosestPoint::Place ClosestPoint::nearest(const Eigen::Vector3d& point_mm) const {
  const Eigen::Vector3d any = Eigen::Vector3d::Zero();
  Nearest query{tree_->triangles, point_mm, any};
  Eigen::BVMinimize(tree_->boxes, query);
  return {query.closest, query.closest_triangle};
}

std::optional<Eigen::Vector3d> ClosestPoint::on_side_facing(const Eigen::Vector3d& direction,
                                                            const Eigen::Vector3d& point_mm) const {
  Nearest query{tree_->triangles, point_mm, direction};
  Eigen::BVMinimize(tree_->boxes, query);
  if (!std::isfinite(query.best)) return std::nullopt;
  return query.closest;
}

bool ClosestPoint::is_within(double distance_mm, const Eigen::Vector3d& point_mm) const {
  AnyWithin query{tree_->triangles, point_mm, distance_mm * distance_mm};
  Eigen::BVIntersect(tree_->boxes, query);
  return query.found;
}

}  // namespace isostack
